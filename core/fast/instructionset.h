// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace pixelplumb {

/// What the fast kernels are compiled for, from one source; the best that the processor has is
/// chosen when the program runs.
enum class InstructionSet {
    Scalar, ///< one lane: every processor
    Neon, ///< 4 lanes of 32 bits
    Sse4, ///< 4 lanes
    Avx2, ///< 8 lanes
    Avx512, ///< 16 lanes, a mask for every store
    Avx512Vbmi, ///< the same with byte permutes across two registers (Ice Lake, Zen 4)
};

/// The name in reports and on the command line: "scalar", "neon", "sse4", …
std::string_view nameOf(InstructionSet set);
std::optional<InstructionSet> instructionSetNamed(std::string_view name);

/// Those that this machine runs, the best last. Never empty.
const std::vector<InstructionSet> &supportedInstructionSets();

} // namespace pixelplumb
