// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace pixelplumb {

/// For comparisons and quotients of numbers too wide for 128 bits: squares of products of lattice
/// coordinates (154 bits), products along two edges (236 bits).
using Int256 = boost::multiprecision::int256_t;

/// For numbers with no good fixed bound: a curve halved until its pixels are decided. It allocates
/// only beyond 128 bits.
using BigInteger = boost::multiprecision::cpp_int;
/// In lowest terms.
using BigRational = boost::multiprecision::cpp_rational;

} // namespace pixelplumb
