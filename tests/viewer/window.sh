#!/usr/bin/env bash
# The viewer in a real window: usage: window.sh GLASSBOX SCENE. Keys enlarge the text, a drag widens the pages, Ctrl+Q
# closes it; then it must have ended well and remember both. Exits 77, skipped, where there is no Xvfb or xdotool.
set -euo pipefail

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# Waits up to 20 s until a command succeeds.
wait_until() {
    local tries
    for ((tries = 0; tries < 200; ++tries)); do
        "$@" && return
        sleep .1
    done
    return 1
}

press() {  # KEY, or MODIFIER KEY
    local key
    for key in "$@"; do xdotool keydown "$key"; sleep "$pause"; done
    for key in "${@: -1}" "${@:1:$#-1}"; do xdotool keyup "$key"; sleep "$pause"; done
}

drag() {  # FROM-X TO-X Y
    xdotool mousemove "$1" "$3"; sleep "$pause"
    xdotool mousedown 1; sleep "$pause"
    xdotool mousemove "$2" "$3"; sleep "$pause"
    xdotool mouseup 1; sleep "$pause"
}

is_there() { xdotool search --onlyvisible --name '^Glassbox$' >"$folder/windows" 2>/dev/null; }
has_ended() { ! kill -0 "$viewer" 2>/dev/null; }

# Whether a number among the settings is within bounds: is_set NAME LEAST MOST.
is_set() {
    awk -v name="\"$1\":" -v least="$2" -v most="$3" \
        '$1 == name { found = $2 + 0 >= least && $2 + 0 <= most } END { exit !found }' "$settings"
}

# Opens the window, changes what can be changed without knowing the font, closes it.
visit() {
    settings=$folder/config$pause/glassbox/viewer.json
    # The display's OpenGL driver leaks a few bytes and is unloaded before leaks are searched for: no suppression could
    # name it. viewer_random_input searches for leaks of ours, in the same interface.
    ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0 \
        XDG_CONFIG_HOME=$folder/config$pause "$glassbox" view "$folder/scene.toml" --size 1024x640 \
        >"$folder/out" 2>"$folder/err" &
    viewer=$!
    wait_until is_there || fail "no window came: $(cat "$folder/err")"
    # The bar left of the pages, font size 18: 0.4 of the 1024 pixels without both margins of 8 are to its right, it
    # is 7 wide, so it lies from 606 to 613. 100 pixels farther left the pages have 0.4 + 100 / 1008 of the width.
    drag 609 509 300
    # Pins a pixel, steps on and back, turns.
    drag 300 300 200
    press bracketright
    press bracketleft
    press d
    # Text of 18 becomes 22.
    press ctrl plus
    press ctrl plus
    press ctrl q
    wait_until has_ended || { kill -KILL "$viewer"; fail "Ctrl+Q did not close the window"; }
    local status=0
    wait "$viewer" || status=$?
    [ "$status" = 0 ] || fail "it ended with status $status: $(cat "$folder/err")"
    [ ! -s "$folder/err" ] || fail "it complained: $(cat "$folder/err")"
    [ -s "$settings" ] || fail "no settings were written"
}

# A signal, as Ctrl+C in the terminal sends one, keeps the settings, too.
interrupt() {
    XDG_CONFIG_HOME=$folder/interrupted "$glassbox" view "$folder/scene.toml" --size 1024x640 \
        >"$folder/out" 2>"$folder/err" &
    viewer=$!
    wait_until is_there || fail "no window came: $(cat "$folder/err")"
    press ctrl plus
    sleep .5
    kill -TERM "$viewer"  # a shell lets what it starts in the background ignore SIGINT
    wait_until has_ended || { kill -KILL "$viewer"; fail "SIGTERM did not end it"; }
    local status=0
    wait "$viewer" || status=$?
    [ "$status" = 130 ] || fail "SIGTERM: it ended with status $status: $(cat "$folder/err")"
    [ -s "$folder/interrupted/glassbox/viewer.json" ] || fail "SIGTERM: no settings were written"
}

in_window() {
    # A busy machine may draw no frame between a press and its release: then once more, slower.
    for pause in .04 .2 .5; do
        visit
        if is_set text_size 22 22 && is_set side_width .49 .51; then return; fi
    done
    fail "the settings are not what was chosen: $(cat "$settings")"
}

# A display of our own. The server takes a number that is free and writes it once clients can come; it stays as it is when
# the last client leaves: one that came while it began anew was turned away.
start_display() {
    Xvfb -displayfd 3 -screen 0 1024x640x24 -nolisten tcp -noreset 3>"$folder/display" >"$folder/xvfb" 2>&1 &
    server=$!
    wait_until is_written "$folder/display" || fail "Xvfb does not start: $(cat "$folder/xvfb")"
    DISPLAY=:$(cat "$folder/display")
    export DISPLAY
}
is_written() { [ "$(wc -l <"$1")" = 1 ]; }

clean_up() {
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    rm -rf "$folder"
}

glassbox=$1 scene=$2 server=
folder=$(mktemp -d)
trap clean_up EXIT
cp "$scene" "$folder/scene.toml"

# Without a display: one line, which names what works without one.
status=0
env -u DISPLAY -u WAYLAND_DISPLAY XDG_CONFIG_HOME="$folder" "$glassbox" view "$folder/scene.toml" \
    2>"$folder/err" || status=$?
[ "$status" = 1 ] || fail "without a display the status is $status, not 1"
[ "$(wc -l <"$folder/err")" = 1 ] || fail "without a display it says: $(cat "$folder/err")"
grep -q 'no display.*--screenshot' "$folder/err" || fail "without a display it says: $(cat "$folder/err")"

for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: there is no $tool"; exit 77; }
done
start_display
in_window
interrupt
