#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run_fuzzers.sh [SECONDS]
# Builds both fuzzers with the other sanitized programs (configure_sanitized.sh) and runs each for 20
# or the given number of seconds. What they find stays in build/fuzzers/; new inputs that reach new
# code are kept there too.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$project/build/fuzzers
seconds=${1:-20}

"$project/tests/configure_sanitized.sh"
cmake --build "$project/build/clang" --target kernelfuzzer scenefuzzer

# run HARNESS OPTIONS-AND-CORPORA...: a find makes libFuzzer exit with an error and name its file.
run() {
    local found=$build/found-$1
    mkdir -p "$found"
    (
        cd "$found"
        "$project/build/clang/tests/fuzz/$1" -max_total_time="$seconds" -print_final_stats=1 -verbosity=0 \
            "${@:2}"
    )
}

code=0
corpus=$project/tests/fuzz/corpus
mkdir -p "$build/kernels" "$build/scenes"
run kernelfuzzer -max_len=128 "$build/kernels" "$corpus/kernel" || code=1
run scenefuzzer -max_len=2048 -dict="$project/tests/fuzz/scene.dict" \
    "$build/scenes" "$corpus/scene" "$project/resources/scenes" || code=1
exit "$code"
