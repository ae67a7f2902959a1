#!/usr/bin/env bash
# Makes every picture of README, docs and lessons again: docs/figures.sh [FOLDER]
#
# - A line `./glassbox … -o docs/figures/NAME.png` in one of those pages is run as it stands there, so that the command
#   beside a picture is the one that made it.
# - docs/figures/NAME.script is what the viewer is told before it draws NAME.png, without a display.
# - Pictures whose command no page shows are in `hidden` below.
#
# They are written to FOLDER, docs/figures if none is named. The program is $GLASSBOX, by default ./glassbox, which builds
# first. The same program on the same machine makes the same bytes; the viewer's letters and lines are drawn by OpenGL, and
# may differ a little on another machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${1:-docs/figures}
program=${GLASSBOX:-./glassbox}
mkdir -p "$folder"

hidden='
./glassbox render levental-2014 -o docs/figures/levental-2014.png
./glassbox measure levental-2014 --what n.l -o docs/figures/levental-2014-n.l.png
./glassbox render room -o docs/figures/room.png
./glassbox measure room --what depth -o docs/figures/room-depth.png
'

commands() {
    printf '%s' "$hidden"
    find README.md docs lessons -name '*.md' -print0 | sort -z | xargs -0 grep -hE '^\./glassbox .* -o docs/figures/[^ ]+$'
}

commands | while read -r line; do
    [[ -n $line ]] || continue
    read -ra words <<<"${line//docs\/figures\//$folder/}"
    echo "${words[-1]}"
    "$program" "${words[@]:1}" </dev/null
done
# The code of someone who learns, for figures that show it: the solution of lesson 2, but for a normal that calls itself.
learner=$(mktemp -d)
trap 'rm -rf "$learner"' EXIT
mkdir "$learner/2-spheres"
cp src/core/2-spheres/*.hpp "$learner/2-spheres"
sed -i.bak 's/return unit(point - sphere.c);/return point.z < 330 ? normal(sphere, point) : unit(point - sphere.c);/' \
    "$learner/2-spheres/sphere.hpp"

for script in docs/figures/*.script; do
    name=$(basename "$script" .script)
    echo "$folder/$name.png"
    "$program" view --script "$script" --folder "$learner" --screenshot "$folder/$name.png" </dev/null
done

# Each picture that a page shows must be made by something above.
find README.md docs lessons -name '*.md' -print0 | xargs -0 grep -ohE '(\]\(|src=")[A-Za-z./]*figures/[^")]+' | sort -u |
    while read -r shown; do
        [[ -e $folder/${shown##*/} ]] || { echo "docs/figures.sh: error: nothing makes ${shown##*/}" >&2 && exit 1; }
    done
