#!/usr/bin/env bash
# Puts the figures into docs/testing.md:
#
#   docs/testing.sh          those that are counted in the sources
#   docs/testing.sh BUILD    and those of a run: of the tests that `./glassbox test` has just run in the folder BUILD
#   docs/testing.sh --check  fails where the first would change the page, and shows what
#
# In a table, the row that begins with a name in `code` takes the numbers that `counted` has for it. A number of lines stays as
# long as it is right to a tenth. Between `<!-- run: begin -->` and `end` stands what depends on the machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=docs/testing.md

# The text of all sources in folders and files that patterns name.
# shellcheck disable=SC2086 # patterns, to be expanded
text() {
    find $1 \( -name '*.cpp' -o -name '*.hpp' -o -name '*.inl' -o -name '*.sh' -o -name '*.awk' -o -name '*.cmake' \) -print0 |
        xargs -0 cat
}
cases() { text "$1" | grep -cE '^ *TEST_CASE(_TEMPLATE)?\(' || true; }
lines() { text "$1" | grep -cvE '^ *(//|#|$)' || true; } # without comments, includes and blanks

# room LABEL "TESTS…" ["SOURCES…"]: cases, lines of the tests, lines of what they test.
room() {
    local cases of=–
    cases=$(cases "$2")
    [[ -z ${3:-} ]] || of="~$(lines "$3")"
    echo "$1 ${cases/#0/–} ~$(lines "$2") $of"
}

# What each row is to say, `~` before a number of lines.
counted() {
    local stage lesson name
    for stage in 1 2 3 4 5 6 7; do
        room stage$stage "tests/stages/stage${stage}_*.cpp" "src/core/$stage-*"
    done
    room core tests/stages/core
    for name in numerics scene engine render output explain compare learn viewer cli library bench; do
        room $name tests/$name src/$name
    done
    room certified "tests/certified tests/oracle tests/fuzz"
    for name in lessons architecture script; do
        room $name tests/$name
    done
    room everything "tests lessons" src
    for lesson in lessons/[0-9]-*; do
        echo "${lesson#*/} $(grep -c '^\[\[function\]\]' "$lesson/exercise.toml")" \
            "$(cases "tests/stages/stage$(basename "$lesson" | cut -c 1)_*.cpp") $(grep -c '^\[\[mistake\]\]' "$lesson/mistakes.toml")"
    done
}

# Reads the page, and writes it with these numbers.
with_counted() {
    awk '
        function right(old, new) { return old > 0 && new >= 0.9 * old && new <= 1.1 * old }
        FNR == NR { known[$1] = $0; next }
        split($0, cell, "|") > 3 && cell[2] ~ /^ *`[^`]*` *$/ {
            name = cell[2]
            gsub(/[` ]/, "", name)
            if (name in known) {
                count = split(known[name], value, " ")
                line = "|" cell[2] "|"
                for (i = 2; i <= count; ++i) {
                    old = cell[i + 1]
                    gsub(/ /, "", old)
                    new = value[i]
                    if (sub(/^~/, "", new) && right(old, new)) new = old
                    line = line " " new " |"
                }
                for (i = count + 2; i in cell && (i + 1) in cell; ++i) line = line cell[i] "|"
                $0 = line
            }
        }
        { print }' <(counted) "$page"
}

# run BUILD: what the tests said that were just run there.
run() {
    local log=$scratch/log label tests
    cp "$1/Testing/Temporary/LastTest.log" "$log" # which ctest -N empties
    echo '| label | tests | checks |'
    echo '|---|---|---|'
    for label in stage{1..7} core numerics scene engine render output explain compare certified learn viewer cli library bench lessons; do
        tests=$(cd "$1" && ctest -N -L "^$label\$" | sed -n 's/^ *Test *#[0-9]*: //p')
        [[ -n $tests ]] || continue
        awk -v label="$label" '
            FNR == NR { wanted[$1]; ++tests; next }
            / Testing: / { name = $NF }
            /^\[doctest\] assertions:/ && name in wanted { checks += $3 }
            END { printf "| `%s` | %d | %s |\n", label, tests, (checks > 0 ? checks : "–") }' <(echo "$tests") "$log"
    done
    echo
    awk '
        / rays in [0-9]+ scenes, [0-9]+ hits/ {
            for (i = 2; i <= NF; ++i) {
                if ($i == "rays") { rays += $(i - 1); ++lists }
                if ($i == "undecided") exactly += $(i - 1)
                if ($i == "wrong") wrong += $(i - 1)
            }
        }
        /^Seeds from / { sub(/^[^:]*: /, ""); sub(/, in [0-9.]* s\.$/, ""); fuzz = $0 }
        END {
            if (lists) printf "The oracle judges %d hard rays. Certified is wrong in none, and asks exact arithmetic %d times; plain double is wrong %d times.\n", rays, exactly, wrong
            if (fuzz) printf "The fuzzer: %s.\n", fuzz
        }' "$log"
    cp "$log" "$1/Testing/Temporary/LastTest.log"
}

# with_run BUILD: reads a page, and writes it with the figures of that run.
with_run() {
    run "$1" | awk '
        FNR == NR { text = text $0 "\n"; next }
        /^<!-- run: end/ { inside = 0 }
        !inside { print }
        /^<!-- run: begin/ { inside = 1; printf "\n%s\n", text }' - "$2"
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
made=$scratch/page
with_counted >"$made"
case ${1:-} in
--check)
    diff -u "$page" "$made" || { echo "$page: error: its figures are old: docs/testing.sh makes them anew" >&2 && exit 1; }
    ;;
'') cat "$made" >"$page" ;;
*)
    with_run "$1" "$made" >"$scratch/with_run"
    cat "$scratch/with_run" >"$page"
    ;;
esac
