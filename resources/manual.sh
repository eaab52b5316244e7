#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# manual.sh PROGRAM PAGE: prints a manual page in which a line @COMMAND@ stands for what PROGRAM
# COMMAND --help prints, without the options of all scenes, for which @settings@ stands.
program=$1
settings='/^  --method <name>  *How to scan-convert/,/May be repeated/'

help() {
    case $1 in
    settings) "$program" render --help | sed -n "${settings}p" ;;
    *) "$program" "$1" --help | sed "${settings}d" && echo End: ;;
    esac
}

# In the help two spaces stand between an option and its text, and many before the text's next line.
while IFS= read -r line; do
    case $line in
    @*@)
        line=${line#@}
        help "${line%@}" | sed -E '
            /^$/d; /^Arguments:/d; /^  -h, --help/d
            s/-/\\-/g
            s/([[:alpha:]]\.) ([A-Z])/\1\n\2/g
            s/^Usage: (.*)/.Dl \1\n.Pp/
            s/^Options:/.Bl -tag -width Ds/
            s/^End:/.El/
            s/^  +([^ ].*[^ ])  +(.*)/.It Sy \1\n\2/
            s/^  +([.'\''])/\\\&\1/
            s/^  +//
        ' ;;
    *) printf '%s\n' "$line" ;;
    esac
done < "$2"
