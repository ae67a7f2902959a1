#!/bin/sh
# edge.sh ROOT: checks that no panel of the viewer in ROOT includes the system, however many headers lie between.
set -eu
rules=$(cd "$(dirname "$0")" && pwd)/edge.awk
cd "$1"
# shellcheck disable=SC2046 # no blanks in our own file names
exec awk -f "$rules" $(find src -name '*.cpp' -o -name '*.hpp' | LC_ALL=C sort)
