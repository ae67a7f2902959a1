#!/usr/bin/env bash
# The time from saving a header to the result of its tests: measured over 10 edits of a lesson, half of them right and
# half of them wrong, while `glassbox learn watch` runs. What passes in double and float is reported at once: that is
# the result. The final verdict comes after long double.
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

now() { date +%s%N; }
result='@(✓ In|Lesson)*' verdict='Watching*'
shopt -s extglob

# wait_for PATTERN: until the watcher prints the next line that matches. Starts no programs, which would take time from
# it.
wait_for() {
    local line deadline=$((SECONDS + 60))
    until IFS= read -r line <&"$told" && [[ $line == $1 ]]; do
        [[ -n $line ]] || read -rt 0.005 <&"$silence" || true
        ((SECONDS < deadline)) || { cat "$log" >&2; echo "no result after 60 s" >&2; exit 1; }
    done
}
exec {silence}<> <(:)

"$program" learn reset "$lesson" --folder "$folder/my" >"$folder/reset"
name=$(basename "$(echo lessons/"$lesson"-*)")
: >"$log"
"$program" learn watch "$lesson" --folder "$folder/my" >"$log" 2>&1 &
watcher=$!
exec {told}<"$log"
wait_for "$verdict"

# The edits: alternately the solution, and the solution with a mistake. A comment makes each a different file.
mapfile -t mistakes < <("$program" learn mistake "$lesson" | awk '{ print $1 }')
results=() verdicts=()
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
    start=$(now)
    for header in $(cd "$next/$name" && find . -name '*.hpp'); do cp "$next/$name/$header" "$folder/my/$name/$header"; done
    wait_for "$result"
    results+=($((($(now) - start) / 1000000)))
    wait_for "$verdict"
    verdicts+=($((($(now) - start) / 1000000)))
    rm -rf "$next"
done

# summary WHAT TIME...
summary() {
    local what=$1 sorted
    shift
    printf 'lesson %s, from save to %s, in ms: %s\n' "$name" "$what" "$*"
    mapfile -t sorted < <(printf '%s\n' "$@" | sort -n)
    printf 'median %d ms, max %d ms\n' $(((sorted[4] + sorted[5]) / 2)) "${sorted[9]}"
}
summary result "${results[@]}"
summary verdict "${verdicts[@]}"
