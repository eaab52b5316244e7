// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/instructionset.h"

namespace pixelplumb {

std::string_view nameOf(InstructionSet set)
{
    switch (set) {
    case InstructionSet::Scalar:
        return "scalar";
    case InstructionSet::Neon:
        return "neon";
    case InstructionSet::Sse4:
        return "sse4";
    case InstructionSet::Avx2:
        return "avx2";
    case InstructionSet::Avx512:
        return "avx512";
    case InstructionSet::Avx512Vbmi:
        return "avx512-vbmi";
    }
    return {};
}

} // namespace pixelplumb
