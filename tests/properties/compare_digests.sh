#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compare_digests.sh SOURCES FOLDER "INCLUDE FOLDERS" LIBRARY...
# Builds digest.cpp with each compiler that there is, at several levels of optimisation, with and
# without fused multiply-add, and compares what the programs print. The digests of exact arithmetic
# must also be the oracle's.
set -euo pipefail

sources=$1
folder=$2
read -ra includes <<<"$3"
# Named once more, it would come before the C++ library's own folders.
mapfile -t includes < <(printf '%s\n' "${includes[@]}" | grep -vx '/usr/include')
libraries=("${@:4}")
mkdir -p "$folder"

flags=(-std=c++20 -ffp-contract=off -fPIC -w -I "$sources" "${includes[@]/#/-isystem}")
ccache=()
if command -v ccache >/dev/null; then
    ccache=(ccache)
fi

# build NAME COMPILER FLAGS...: one object a source, so that a compiler cache can keep them.
build() {
    local name=$1 compiler=$2 objects=() source
    shift 2
    for source in tests/properties/digest core/oracle/oracle core/number/quantity; do
        objects+=("$folder/$name-${source##*/}.o")
        "${ccache[@]}" "$compiler" "${flags[@]}" "$@" -c "$sources/$source.cpp" -o "${objects[-1]}"
    done
    "$compiler" "${objects[@]}" "${libraries[@]}" -o "$folder/$name"
}

builds=()
add() {
    local name=$1
    build "$@"
    "$folder/$name" >"$folder/$name.txt"
    builds+=("$name")
}

gcc=$(command -v g++-12 || command -v g++ || true)
clang=$(command -v clang++-14 || command -v clang++ || true)
fma=()
if grep -qw fma /proc/cpuinfo 2>/dev/null; then
    fma=(-mfma)
fi
if [[ -n $gcc ]]; then
    add gcc-O0 "$gcc" -O0
    add gcc-O3 "$gcc" -O3
    add gcc-native "$gcc" -O3 -march=native
fi
if [[ -n $clang ]]; then
    add clang-O2 "$clang" -O2
    add clang-O3-fma "$clang" -O3 "${fma[@]}"
fi
if [[ ${#builds[@]} -lt 2 ]]; then
    echo "There are not two builds to compare: neither g++ nor clang++ is installed." >&2
    exit 1
fi

code=0
for name in "${builds[@]:1}"; do
    if ! diff --label "${builds[0]}" --label "$name" -u "$folder/${builds[0]}.txt" "$folder/$name.txt"; then
        code=1
    fi
done
# The same pictures under two names: the rule and the digest of "exact" and of "oracle".
digests() {
    awk -v name="$1" '$1 == name && $2 != "top-left" { print $2, $3 }' "$folder/${builds[0]}.txt"
}
if [[ $(digests exact) != "$(digests oracle)" || -z $(digests exact) ]]; then
    echo "The digests of exact arithmetic are not the oracle's." >&2
    code=1
fi
cat "$folder/${builds[0]}.txt"
printf 'the same with: %s\n' "${builds[*]}"
exit "$code"
