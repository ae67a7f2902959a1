#!/usr/bin/env bash
# Makes every picture of README, docs and lessons again: docs/figures.sh [FOLDER]
#
# - A line `./glassbox … -o docs/figures/NAME.png`, or to a lesson's figures, in one of those pages is run as it stands
#   there, so that the command beside a picture is the one that made it.
# - docs/figures/NAME.script is what the viewer is told before it draws NAME.png, without a display.
# - docs/moving.sh makes the one that moves.
# - Pictures whose command no page shows are in `hidden` below; drawings, .svg, are made by hand.
#
# They are written to where they belong, or to the same places in FOLDER. The program is $GLASSBOX, by default ./glassbox,
# which builds first. The same program on the same machine makes the same bytes; the viewer's letters and lines are drawn by
# OpenGL, and may differ a little on another machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=${1:-.}
program=${GLASSBOX:-./glassbox}
for folder in docs/figures lessons/*/figures; do mkdir -p "$out/$folder"; done

hidden='
./glassbox render levental-2014 --sphere levental-2014 -o docs/figures/levental-2014.png
./glassbox measure levental-2014 --what n.l -o docs/figures/levental-2014-n.l.png
./glassbox render room -o docs/figures/room.png
./glassbox measure room --what depth -o docs/figures/room-depth.png
'

commands() {
    printf '%s' "$hidden"
    find README.md docs lessons -name '*.md' -print0 | sort -z |
        xargs -0 grep -hE '^\./glassbox .* -o (docs|lessons/[^ ]*)/figures/[^ ]+$'
}

commands | while read -r line; do
    [[ -n $line ]] || continue
    read -ra words <<<"$line"
    echo "${words[-1]}"
    "$program" "${words[@]:1:${#words[@]}-2}" "$out/${words[-1]}" </dev/null
done
# The code of someone who learns, for figures that show it: the solution of lesson 2, but for a normal that calls itself;
# that of lesson 3, but for a t that is not divided by the sum of the weights.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
learner=$scratch/my  # its name is in a picture
mkdir -p "$learner/2-spheres" "$learner/3-triangles"
cp src/core/2-spheres/*.hpp "$learner/2-spheres"
cp src/core/3-triangles/*.hpp "$learner/3-triangles"
sed -i.bak 's, / (a + b + c);,;,' "$learner/3-triangles/sides.hpp"
sed -i.bak 's/return unit(X - sphere.C);/return X.z < 330 ? normal(sphere, X) : unit(X - sphere.C);/' \
    "$learner/2-spheres/sphere.hpp"

for script in docs/figures/*.script; do
    name=$(basename "$script" .script)
    echo "docs/figures/$name.png"
    "$program" view --script "$script" --folder "$learner" --screenshot "$out/docs/figures/$name.png" </dev/null
done

# The moving picture needs a library of its own.
if command -v convert >/dev/null; then
    echo docs/figures/viewer.gif
    docs/moving.sh "$out"
else
    echo 'docs/figures.sh: there is no convert, of imagemagick: docs/figures/viewer.gif stays as it is' >&2
    [[ $out == . ]] || cp docs/figures/viewer.gif "$out/docs/figures"
fi

# Each picture that a page shows must be made by something above.
find README.md docs lessons -name '*.md' | sort | while read -r page; do
    { grep -ohE '(\]\(|src=")[A-Za-z./]*figures/[^")]+' "$page" || true; } | sed -E 's/^(\]\(|src=")//' | while read -r shown; do
        [[ $shown == *.svg || -e $out/$(dirname "$page")/$shown ]] ||
            { echo "docs/figures.sh: error: $page shows $shown, which nothing makes" >&2 && exit 1; }
    done
done
