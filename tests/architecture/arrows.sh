#!/bin/sh
# arrows.sh ROOT: checks the includes of all C++ in ROOT/src and ROOT/lessons against the arrows between the rooms.
set -eu
rules=$(cd "$(dirname "$0")" && pwd)/arrows.awk
cd "$1"
# shellcheck disable=SC2046 # no blanks in our own file names
exec awk -f "$rules" $(find src lessons -name '*.cpp' -o -name '*.hpp' | LC_ALL=C sort)
