// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/instructionset.h"

#include <array>

namespace pixelplumb {

std::string_view nameOf(InstructionSet set)
{
    static constexpr std::array names = {"scalar", "neon", "sse4", "avx2", "avx512", "avx512-vbmi"};
    static_assert(names.size() == std::size_t(InstructionSet::Avx512Vbmi) + 1);
    return names[std::size_t(set)];
}

} // namespace pixelplumb
