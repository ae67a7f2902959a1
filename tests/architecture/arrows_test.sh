#!/bin/sh
# Shows that arrows.sh finds each include in the folder broken/ that is marked as wrong, and no other.
set -eu
cd "$(dirname "$0")"
places() { grep -o '^[^:]*:[0-9]*' | LC_ALL=C sort; }
expected=$(cd broken && grep -rn '// wrong' . | sed 's|^\./||' | places)
if got=$(./arrows.sh broken); then
    echo "arrows.sh is content with the folder broken/"
    exit 1
fi
if [ "$(echo "$got" | places)" != "$expected" ]; then
    printf 'expected errors at:\n%s\n\ngot:\n%s\n' "$expected" "$got"
    exit 1
fi
