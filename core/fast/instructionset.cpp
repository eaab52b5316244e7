// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/instructionset.h"

#include <array>

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

std::optional<InstructionSet> instructionSetNamed(std::string_view name)
{
    constexpr std::array sets
        = {InstructionSet::Scalar, InstructionSet::Neon,   InstructionSet::Sse4,
           InstructionSet::Avx2,   InstructionSet::Avx512, InstructionSet::Avx512Vbmi};
    for (const InstructionSet set : sets) {
        if (nameOf(set) == name)
            return set;
    }
    return std::nullopt;
}

} // namespace pixelplumb
