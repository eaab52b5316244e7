// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace pixelplumb {

/// The instruction sets for which the fast kernels are compiled from one source; the best that the
/// processor supports is chosen at run time.
enum class InstructionSet {
    Scalar, ///< one lane: every processor
    Neon, ///< 4 lanes of 32 bits
    Sse4, ///< 4 lanes
    Avx2, ///< 8 lanes
    Avx512, ///< 16 lanes, a mask for every store
    Avx512Vbmi, ///< also byte permutes across two registers (Ice Lake, Zen 4)
};

/// The name in reports: "scalar", "neon", "sse4", …
std::string_view nameOf(InstructionSet set);

/// The sets that this machine supports, the best last. Never empty.
const std::vector<InstructionSet> &supportedInstructionSets();

} // namespace pixelplumb
