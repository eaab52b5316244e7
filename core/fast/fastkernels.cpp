// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastkernels.h"

#include "core/fast/boundinglines.h"
#include "core/fast/routechoice.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

// Disabled: sets that are best for no current processor, and vectors without a compile-time size.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#define HWY_WANT_AVX3_DL

// foreach_target.h compiles this file and those that it includes once for each target: it has to
// come first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fast/fastkernels.cpp"
// clang-format off
#include <hwy/foreach_target.h>

#include "core/fast/batchscan-inl.h"
// clang-format on

#if HWY_ONCE

namespace pixelplumb {

namespace {

HWY_EXPORT(drawBatch);
HWY_EXPORT(drawFloatStrip);

struct TargetName {
    InstructionSet set;
    std::int64_t target;
};

constexpr std::array targetNames = {
    TargetName{InstructionSet::Scalar, HWY_STATIC_TARGET},
    TargetName{InstructionSet::Neon, HWY_NEON},
    TargetName{InstructionSet::Sse4, HWY_SSE4},
    TargetName{InstructionSet::Avx2, HWY_AVX2},
    TargetName{InstructionSet::Avx512, HWY_AVX3},
    TargetName{InstructionSet::Avx512Vbmi, HWY_AVX3_DL},
};

std::vector<InstructionSet> detectedSets()
{
    const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
    std::vector<InstructionSet> sets;
    for (const TargetName &name : targetNames) {
        if (name.set == InstructionSet::Scalar || (targets & name.target) != 0)
            sets.push_back(name.set);
    }
    return sets;
}

} // namespace

const std::vector<InstructionSet> &supportedInstructionSets()
{
    // Queried once: on a virtual machine each query of the processor takes microseconds.
    static const std::vector<InstructionSet> sets = detectedSets();
    return sets;
}
FastKernels fastKernelsFor(InstructionSet set)
{
    hwy::ChosenTarget chosen;
    for (const TargetName &name : targetNames) {
        if (name.set == set)
            chosen.Update(name.target);
    }
    // The table has one entry where the compiler has one target.
    const std::size_t entries = std::size(HWY_DISPATCH_TABLE(drawBatch));
    const std::size_t index = entries == 1 ? 0 : chosen.GetIndex();
    return {HWY_DISPATCH_TABLE(drawBatch)[index], HWY_DISPATCH_TABLE(drawFloatStrip)[index]};
}

} // namespace pixelplumb

#endif
