#!/usr/bin/env bash
# Makes the moving picture at the top of README again: docs/moving.sh [FOLDER]. It is written to docs/figures, or to the same
# place in FOLDER. Needs ImageMagick. The program is $GLASSBOX, by default ./glassbox, which builds first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v convert >/dev/null || { echo "docs/moving.sh: error: there is no convert; install imagemagick" >&2 && exit 1; }

out=$(realpath "${1:-.}")/docs/figures
program=$(realpath "${GLASSBOX:-./glassbox}")
script=$(realpath docs/moving/viewer.script)
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
mkdir -p "$out"
(cd "$frames" && "$program" view --script "$script" </dev/null)
arguments=()
for frame in "$frames"/*.png; do
    name=$(basename "$frame" .png)
    arguments+=(-delay "${name#*-}" "$frame")
done
convert "${arguments[@]}" -loop 0 +dither -colors 128 -layers Optimize "$frames/viewer.gif"
size=$(wc -c <"$frames/viewer.gif")
((size < 3000000)) || { echo "docs/moving.sh: error: it has $size bytes; it must have fewer than 3,000,000" >&2 && exit 1; }
mv "$frames/viewer.gif" "$out/viewer.gif"
