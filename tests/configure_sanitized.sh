#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# configure_sanitized.sh
# Prepares build/clang: everything by the second compiler, with its sanitizers and with warnings as
# errors. It is one build for the tests and for the fuzzers: core takes minutes to compile so.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
compiler=$(command -v clang++-14 || command -v clang++)

# Not optimised: the kernels in all their numbers compile three times as fast, and run half as fast.
# Without debug lines a fifth of that time is saved, too: what is undefined names its line anyway, and
# a stack its functions.
exec cmake -S "$project" -B "$project/build/clang" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O0" -DCMAKE_CXX_COMPILER="$compiler" \
    -DPIXELPLUMB_TESTS=ON -DPIXELPLUMB_BENCHMARKS=ON -DPIXELPLUMB_FUZZERS=ON \
    -DPIXELPLUMB_WERROR=ON \
    "-DPIXELPLUMB_SANITIZE=address;undefined;float-cast-overflow"
