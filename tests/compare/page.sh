#!/usr/bin/env bash
# What docs/compare.md shows is what its commands print: page.sh GLASSBOX PAGE
#
# Each block of ```sh is run in one folder, by bash, and prints the block that follows it, if that has no language.
# Commands may end with the status 1: that something differs.
set -euo pipefail
program=$(realpath "$1") page=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$program" glassbox

awk '
/^```/ && !inside { language = substr($0, 4); inside = 1; n += language == "sh"; next }
/^```/ { inside = 0; next }
inside && language == "sh" { print > sprintf("%02d.sh", n) }
inside && language == "" && n > 0 { print > sprintf("%02d.shown", n) }
' "$page"

failed=0 count=0
for commands in ??.sh; do
    shown=${commands%.sh}.shown said=${commands%.sh}.said
    bash "$commands" >"$said" 2>"$said.err" </dev/null || [[ $? == 1 ]] || { echo "$page: error: $(cat "$commands"): $(cat "$said.err")"; failed=1; }
    [[ ! -e $shown ]] || diff "$shown" "$said" || failed=1
    count=$((count + 1))
done
((count > 1)) || { echo "$page: error: no commands in it to try"; failed=1; }
exit $failed
