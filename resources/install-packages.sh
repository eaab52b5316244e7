#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install-packages.sh SECTION...
# Installs what is missing of those sections of debian-packages.txt. Says nothing and needs no
# network when nothing is missing.
set -euo pipefail

list=$(dirname "${BASH_SOURCE[0]}")/debian-packages.txt

# The lines of the sections in "$@": "package" or "package | alternative".
listed_packages() {
    local line section=
    while IFS= read -r line; do
        line=${line%%#*}
        line=${line%"${line##*[![:space:]]}"}
        case $line in
            '') ;;
            '['*']') section=${line:1:-1} ;;
            *) [[ " $* " != *" $section "* ]] || printf '%s\n' "$line" ;;
        esac
    done <"$list"
}

is_installed() {
    [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

is_available() {
    [[ -n $(apt-cache madison "$1" 2>/dev/null) ]]
}

# The lines of which no alternative is installed.
missing_lines() {
    local line package
    while IFS= read -r line; do
        for package in ${line//|/ }; do
            is_installed "$package" && continue 2
        done
        printf '%s\n' "$line"
    done < <(listed_packages "$@")
}

# The first alternative that this system has; the first one when it has none, so that apt names it.
choose() {
    local package
    for package in "$@"; do
        if is_available "$package"; then
            printf '%s\n' "$package"
            return
        fi
    done
    printf '%s\n' "$1"
}

[[ $# -gt 0 ]] || { echo "usage: ${0##*/} SECTION..." >&2 && exit 2; }

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian or Ubuntu system: install what ${list##*/} names yourself." >&2
    exit 0
fi

mapfile -t missing < <(missing_lines "$@")
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        {
            echo "These packages are missing, and installing them needs root or sudo:"
            printf '    %s\n' "${missing[@]}"
            echo "As root: $(realpath "${BASH_SOURCE[0]}") $*"
        } >&2
        exit 1
    fi
    as_root=(sudo)
fi

{
    echo "Installing what is missing:"
    printf '    %s\n' "${missing[@]}"
} >&2

# What apt prints goes to stderr: stdout belongs to the program that is to be started.
{
    "${as_root[@]}" apt-get update --quiet || echo "Going on with the old package lists."
    packages=()
    for line in "${missing[@]}"; do
        read -ra alternatives <<<"${line//|/ }"
        packages+=("$(choose "${alternatives[@]}")")
    done
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install --quiet --yes --no-install-recommends "${packages[@]}"
} >&2
