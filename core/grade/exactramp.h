// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/exacttrack.h"
#include "core/grade/redrawing.h"

#include <type_traits>
#include <vector>

namespace pixelplumb {

/// A level along a span in fractions: at its first sample, and what is added to it.
template <class Integer>
struct ExactRamp {
    Integer first, step;
    Integer denominator; ///< of both; > 0

    /// With something of another denominator added to its first sample.
    ExactRamp preSteppedBy(const Integer &added, const Integer &ofAdded) const
    {
        return {first * ofAdded + added * denominator, step * ofAdded, denominator * ofAdded};
    }

    /// The whole levels at the samples. Quotients and remainders are stepped: nothing is divided
    /// from sample to sample, and what half of the width holds is stepped in it, which takes a
    /// fraction of the time.
    void storeFloors(std::vector<WholeLevels> &levels, std::size_t channel) const
    {
        if constexpr (std::is_same_v<Integer, Int256>) {
            static const Int256 half = Int256(1) << 125;
            if (absolute(first) < half && absolute(step) < half && denominator < half)
                return ExactRamp<Int128>{Int128(first), Int128(step), Int128(denominator)}
                    .storeFloors(levels, channel);
        }
        const Integer level = leftOf<Integer>(first, denominator, Kept::Down);
        const Integer levelStep = leftOf<Integer>(step, denominator, Kept::Down);
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
