// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace pixelplumb {

/// 50 decimal digits: what a double of projection or light would be without rounding, to within
/// 1e-40. The scene's own doubles count as exact.
using ExactReal = boost::multiprecision::cpp_bin_float_50;

} // namespace pixelplumb
