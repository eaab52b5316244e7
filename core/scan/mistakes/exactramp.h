// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/exacttrack.h"
#include "core/scan/mistakes/walkedtriangle.h"

#include <type_traits>
#include <vector>

namespace pixelplumb {

/// A level along a span in fractions: its first sample's, and the step.
template <class Integer>
struct ExactRamp {
    Integer first, step;
    Integer denominator; ///< of both; > 0

    /// Adds a fraction, added / ofAdded, to the first sample.
    ExactRamp preSteppedBy(const Integer &added, const Integer &ofAdded) const
    {
        return {first * ofAdded + added * denominator, step * ofAdded, denominator * ofAdded};
    }

    /// Stores the whole levels at the samples. Quotient and remainder are stepped separately,
    /// without division at each sample, and in half the width where that suffices, which is much
    /// faster.
    void storeFloors(std::vector<WholeLevels> &levels, std::size_t channel) const
    {
        if constexpr (std::is_same_v<Integer, Int256>) {
            static const Int256 half = Int256(1) << 125;
            if (absolute(first) < half && absolute(step) < half && denominator < half)
                return ExactRamp<Int128>{Int128(first), Int128(step), Int128(denominator)}
                    .storeFloors(levels, channel);
        }
        const Integer level = leftOf<Integer>(first, denominator, Truncation::Down);
        const Integer levelStep = leftOf<Integer>(step, denominator, Truncation::Down);
        Integer rest = first - level * denominator;
        const Integer restStep = step - levelStep * denominator;
        auto whole = std::int64_t(level);
        const auto wholeStep = std::int64_t(levelStep);
        for (WholeLevels &each : levels) {
            each[channel] = whole;
            whole += wholeStep;
            rest += restStep;
            if (rest >= denominator) {
                ++whole;
                rest -= denominator;
            }
        }
    }
};

} // namespace pixelplumb
