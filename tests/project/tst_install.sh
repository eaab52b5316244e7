#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tst_install.sh CMAKE BUILD_FOLDER SCRATCH_FOLDER CONFIGURATION
# What is installed is complete, and the headless program runs from where it was installed.
set -euo pipefail

cmake=$1 build=$2 scratch=$3 configuration=$4

fail() {
    echo "FAIL: $*" >&2
    exit 1
}

rm -rf "$scratch"
env -u DESTDIR "$cmake" --install "$build" --prefix "$scratch" --config "$configuration" >/dev/null

for file in \
    bin/pixelplumb \
    bin/pixelplumb-cli \
    share/applications/org.pixelplumb.Pixelplumb.desktop \
    share/mime/packages/org.pixelplumb.Pixelplumb.xml \
    share/metainfo/org.pixelplumb.Pixelplumb.metainfo.xml \
    share/icons/hicolor/scalable/apps/org.pixelplumb.Pixelplumb.svg \
    share/man/man1/pixelplumb.1 \
    share/man/man1/pixelplumb-cli.1 \
    share/bash-completion/completions/pixelplumb-cli \
    share/zsh/vendor-completions/_pixelplumb-cli \
    share/doc/pixelplumb/GPL-3.0-or-later.txt \
    share/doc/pixelplumb/assignment-file.md \
    share/doc/pixelplumb/glossary.md \
    share/doc/pixelplumb/misprints.md \
    share/doc/pixelplumb/numerics.md \
    share/doc/pixelplumb/scene-file.md \
    share/doc/pixelplumb/sources.md \
    share/doc/pixelplumb/student-program.md \
    share/pixelplumb/scenes/default.json; do
    [[ -s $scratch/$file ]] || fail "$file is not installed"
done

cd "$scratch"
methods=$(bin/pixelplumb-cli methods) || fail "pixelplumb-cli methods ended with $?"
[[ -n $methods ]] || fail "pixelplumb-cli methods printed nothing"
bin/pixelplumb-cli render share/pixelplumb/scenes/default.json -o default.png \
    || fail "pixelplumb-cli render ended with $?"
[[ $(head -c 4 default.png) == $'\x89PNG' ]] || fail "default.png is no PNG"

version=$(bin/pixelplumb-cli --version) || fail "pixelplumb-cli --version ended with $?"
[[ $version == *[0-9].[0-9]* ]] || fail "pixelplumb-cli --version printed '$version'"

# The window's program is asked where there is no display.
for words in --version --help; do
    env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM bin/pixelplumb $words | grep -q pixelplumb \
        || fail "pixelplumb $words without a display"
done

echo "PASS: installed to $scratch"
