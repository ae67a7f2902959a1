#!/usr/bin/env bash
# A lesson's commands do what the lesson says: commands.sh GLASSBOX LESSON [SCRATCH]
#
# Runs each line of LESSON's README.md that is in a block of ```sh and begins with ./glassbox, as it is printed, except:
# - output to lessons/…/figures/ goes to a scratch folder, and must equal the existing picture, byte for byte;
# - the viewer draws into a file, as there may be no display;
# - a learner's folder is made for this run. `learn test` may fail: nothing has been written in it;
# - `test` is not run: this is a test itself.
# Each figure that the lesson shows must exist, and each that exists must be shown. $PREPARED, if there is one, is a folder of
# what `learn` has made once for other tests: see tests/learn/prepared.hpp.
set -euo pipefail
program=$(realpath "$1") lesson=$(realpath "$2")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
name=lessons/$(basename "$lesson")
text=$name/README.md
scratch=${3:-}
if [[ -z $scratch ]]; then
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
fi
mkdir -p "$scratch/$name/figures"
cd "$root"

# copy_prepared FROM TO: each folder whole or not at all, as other tests may be doing the same.
copy_prepared() {
    local folder name making=$2/copying-$$
    mkdir -p "$2"
    for folder in "$1"/tools-* "$1"/drawing-*; do
        name=${folder##*/}
        [[ -d $folder && ! -e $2/$name ]] || continue
        mkdir "$making"
        case $name in
        tools-*) cp "$folder"/* "$making" ;;
        *) cp "$folder"/prelude* "$making" ;;
        esac
        mv -T "$making" "$2/$name" 2>/dev/null || rm -rf "$making"
    done
}
[[ -z ${PREPARED:-} ]] || copy_prepared "$PREPARED" "$scratch/my/.glassbox"

failed=0
wrong() {
    echo "$text:$1: error: $2"
    failed=1
}

# A line number and a command, for each.
commands() { awk '/^ *```/ { inside = !inside && /```sh/; next } inside && /^ *\.\/glassbox( |$)/ { print FNR, $0 }' "$text"; }

count=0
while read -r number line; do
    read -ra words <<<"${line%%  #*}"
    arguments=()
    before=''
    for word in "${words[@]:1}"; do
        case $before/$word in
        -o/lessons/*/figures/*) arguments+=("$scratch/$word") ;;
        -o/* | --out/*) arguments+=("$scratch/${word##*/}") ;;
        */lessons/*) arguments+=("$root/$word") ;;
        */my | */my/*) arguments+=("$scratch/$word") ;;
        *) arguments+=("$word") ;;
        esac
        before=$word
    done
    may_fail=no
    case ${words[1]:-} in
    test) continue ;;
    learn)
        arguments+=(--folder "$scratch/my")
        [[ ${words[2]:-} != test ]] || may_fail=yes
        ;;
    view)
        [[ $line == *--screenshot* ]] || arguments+=(--screenshot "$scratch/view.png")
        [[ $line != *--mine* ]] || arguments+=(--folder "$scratch/my")
        ;;
    esac
    count=$((count + 1))
    status=0
    (cd "$scratch" && ln -sfn "$root/scenes" scenes && "$program" "${arguments[@]}" </dev/null >"$scratch/said" 2>&1) || status=$?
    [[ $status == 0 || ($status == 1 && $may_fail == yes) ]] ||
        wrong "$number" "${line}: exit status $status: $(tail -n 3 "$scratch/said")"
    for word in "${words[@]}"; do
        [[ $word == lessons/*/figures/* ]] || continue
        cmp -s "$word" "$scratch/$word" || wrong "$number" "$word is not the picture that this command makes now"
    done
done < <(commands)
((count > 0)) || wrong 1 "there is no command in it to try"

shown=$(grep -oE '(\]\(|src=")figures/[^")]+' "$text" | sed 's/.*figures\///' | sort -u)
for figure in $shown; do
    [[ -e $name/figures/$figure ]] || wrong 1 "it shows figures/$figure, which is not there"
done
for figure in "$name"/figures/*; do
    grep -qxF "${figure##*/}" <<<"$shown" || wrong 1 "it does not show $figure, which is there"
done
[[ -z ${PREPARED:-} ]] || copy_prepared "$scratch/my/.glassbox" "$PREPARED"
echo "$text: $count commands"
exit $failed
