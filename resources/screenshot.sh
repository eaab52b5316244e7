#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# screenshot.sh [--steps COUNT] [--keys "KEY KEY ..."] [--wait SECONDS] [--output PICTURE]
#               [--size WIDTHxHEIGHT] [--language LANGUAGE] [--] [ARGUMENT...]
#
# Starts the window of the release build on a screen of its own, steps some columns by F10, presses
# the keys (by their names for xdotool), waits, and takes a picture of it into
# resources/screenshots/window.png. The other arguments go to the program (--palette dark, a scene),
# QT_SCALE_FACTOR=2 in the environment draws it at twice the size. The accuracy lab after its run:
#
#     screenshot.sh --keys "alt+0 alt+r" --wait 40 --output resources/screenshots/lab.png
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$project/build/release/app/pixelplumb
picture=$project/resources/screenshots/window.png
size=1440x960
steps=3
keys=
pause=1
language=en

while [[ $# -gt 0 ]]; do
    case $1 in
        --steps) steps=$2 && shift 2 ;;
        --keys) keys=$2 && shift 2 ;;
        --wait) pause=$2 && shift 2 ;;
        --output) picture=$2 && shift 2 ;;
        --size) size=$2 && shift 2 ;;
        --language) language=$2 && shift 2 ;;
        --) shift && break ;;
        *) break ;;
    esac
done

[[ -x $program ]] || { echo "$program is not there: app/run builds it." >&2 && exit 1; }

# The size is in the program's pixels, of which a scale factor makes several of the screen's.
scaled() {
    awk -v side="$1" -v scale="${QT_SCALE_FACTOR:-1}" 'BEGIN { printf "%d", side * scale + 0.5 }'
}
width=$(scaled "${size%x*}")
height=$(scaled "${size#*x}")

# From here on inside the screen that xvfb-run makes.
if [[ ${PIXELPLUMB_SCREEN:-} != own ]]; then
    export PIXELPLUMB_SCREEN=own
    exec xvfb-run --auto-servernum --server-args="-screen 0 ${width}x${height}x24 -nolisten tcp" \
        "${BASH_SOURCE[0]}" --steps "$steps" --keys "$keys" --wait "$pause" --output "$picture" \
        --size "$size" --language "$language" -- "$@"
fi

# No settings of the person's: the window looks the same everywhere.
settings=$(mktemp -d)
window_process=
cleanup() {
    [[ -z $window_process ]] || kill "$window_process" 2>/dev/null || true
    rm -rf "$settings"
}
trap cleanup EXIT

XDG_CONFIG_HOME=$settings XDG_DATA_HOME=$settings XDG_RUNTIME_DIR=$settings LC_ALL=C.UTF-8 LANGUAGE=$language QT_QPA_PLATFORM=xcb \
    "$program" "$@" &
window_process=$!

# Waits until a window of the program is on the screen, at most 20 s.
window=
for ((attempt = 0; attempt < 100; ++attempt)); do
    kill -0 "$window_process" 2>/dev/null || { echo "The program ended early." >&2 && exit 1; }
    window=$(xdotool search --onlyvisible --pid "$window_process" --name . 2>/dev/null | tail -n 1) || true
    [[ -z $window ]] || break
    sleep 0.2
done
[[ -n $window ]] || { echo "No window came up." >&2 && exit 1; }

# There is no window manager: the window fills the screen and gets the keys because we say so.
xdotool windowmove "$window" 0 0 windowsize "$window" "$width" "$height" windowfocus "$window"
sleep 1
for ((pressed = 0; pressed < steps; ++pressed)); do
    xdotool key F10
    sleep 0.1
done
for key in $keys; do
    xdotool key "$key"
    sleep 0.5
done
sleep "$pause"

mkdir -p "$(dirname "$picture")"
import -window "$window" -strip "$picture"
echo "$picture"
