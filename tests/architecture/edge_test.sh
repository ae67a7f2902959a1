#!/bin/sh
# Shows that edge.sh finds both ways by which a panel in the folder broken/ reaches the system, and no other.
set -eu
cd "$(dirname "$0")"
way='src/viewer/ui/shelf/shelf.cpp -> viewer/model/work.hpp ->'
wrong='error: a panel reaches the system'
expected="$way thread: $wrong
$way learn/subprocess/subprocess.hpp: $wrong"
if got=$(./edge.sh broken); then
    echo "edge.sh is content with the folder broken/"
    exit 1
fi
if [ "$got" != "$expected" ]; then
    printf 'expected:\n%s\n\ngot:\n%s\n' "$expected" "$got"
    exit 1
fi
