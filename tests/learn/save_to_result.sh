#!/usr/bin/env bash
# How long it takes from saving a header to the result of its tests: measured over 10 edits of a lesson, half of them right
# and half of them wrong, while `glassbox learn watch` runs.
#
#   tests/learn/save_to_result.sh [PROGRAM [LESSON]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
program=${1:-$root/build/bin/glassbox}
lesson=${2:-2}
cd "$root"

folder=$(mktemp -d)
log=$folder/log
watcher=
end() {
    [[ -z $watcher ]] || kill "$watcher" 2>/dev/null || true
    wait
    rm -rf "$folder"
}
trap end EXIT

results() { grep -c '^Watching' "$log" || true; }
now() { date +%s%N; }

# wait_for_result N: until the watcher has told N results.
wait_for_result() {
    local deadline=$((SECONDS + 60))
    while (($(results) < $1)); do
        ((SECONDS < deadline)) || { cat "$log" >&2; echo "no result after 60 s" >&2; exit 1; }
        sleep 0.01
    done
}

"$program" learn reset "$lesson" --folder "$folder/my" >"$folder/reset"
name=$(basename "$(echo lessons/"$lesson"-*)")
"$program" learn watch "$lesson" --folder "$folder/my" >"$log" 2>&1 &
watcher=$!
wait_for_result 1

# The edits: the solution, then it with a mistake, by turns. A comment makes each another file.
mapfile -t mistakes < <("$program" learn mistake "$lesson" | awk '{ print $1 }')
times=()
for edit in {0..9}; do
    next="$folder/next"
    mkdir -p "$next"
    "$program" learn reset "$lesson" --folder "$next" >/dev/null
    if ((edit % 2)); then
        "$program" learn mistake "$lesson" "${mistakes[edit]}" --folder "$next" >/dev/null
    else
        "$program" learn mistake "$lesson" "${mistakes[0]}" --folder "$next" >/dev/null
        core=$(sed -n 's/^core = "\(.*\)"/\1/p' "lessons/$name/exercise.toml")
        find "$next/$name" -name '*.hpp' | while read -r header; do cp "$core/$(basename "$header")" "$header"; done
    fi
    for header in $(cd "$next/$name" && find . -name '*.hpp'); do echo "// edit $edit" >>"$next/$name/$header"; done
    before=$(results)
    start=$(now)
    for header in $(cd "$next/$name" && find . -name '*.hpp'); do cp "$next/$name/$header" "$folder/my/$name/$header"; done
    wait_for_result $((before + 1))
    times+=($((($(now) - start) / 1000000)))
    rm -rf "$next"
done

printf 'lesson %s, from save to result, in ms:' "$name"
printf ' %s' "${times[@]}"
mapfile -t sorted < <(printf '%s\n' "${times[@]}" | sort -n)
printf '\nmedian %d ms, max %d ms\n' $(((sorted[4] + sorted[5]) / 2)) "${sorted[9]}"
