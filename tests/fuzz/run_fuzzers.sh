#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run_fuzzers.sh [SECONDS]
# Builds both fuzzers with clang and its sanitizers and runs each for 20 or the given number of
# seconds. What they find stays in build/fuzzers/; new inputs that reach new code are kept there
# too. Without clang's fuzzer runtime (libclang-rt-14-dev) it says so and does nothing.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$project/build/fuzzers
seconds=${1:-20}

compiler=$(command -v clang++-14 || command -v clang++ || true)
runtimes=()
if [[ -n $compiler ]]; then
    mapfile -t runtimes < <(find -L "$("$compiler" --print-resource-dir)" -name 'libclang_rt.fuzzer*')
fi
if [[ ${#runtimes[@]} -eq 0 ]]; then
    echo "clang's fuzzer runtime is not installed: nothing is fuzzed."
    exit 0
fi

sanitizers="fuzzer-no-link;address;undefined;float-cast-overflow"
cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1" -DCMAKE_CXX_COMPILER="$compiler" -DPIXELPLUMB_TESTS=ON -DPIXELPLUMB_FUZZERS=ON \
    "-DPIXELPLUMB_SANITIZE=$sanitizers"
cmake --build "$build" --target kernelfuzzer scenefuzzer

# run HARNESS OPTIONS-AND-CORPORA...: a find makes libFuzzer exit with an error and name its file.
run() {
    local found=$build/found-$1
    mkdir -p "$found"
    (
        cd "$found"
        "$build/tests/fuzz/$1" -max_total_time="$seconds" -print_final_stats=1 -verbosity=0 \
            "${@:2}"
    )
}

code=0
corpus=$project/tests/fuzz/corpus
mkdir -p "$build/kernels" "$build/scenes"
run kernelfuzzer -max_len=128 -use_value_profile=1 "$build/kernels" "$corpus/kernel" || code=1
run scenefuzzer -max_len=2048 -dict="$project/tests/fuzz/scene.dict" \
    "$build/scenes" "$corpus/scene" "$project/resources/scenes" || code=1
exit "$code"
