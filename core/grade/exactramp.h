// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/exacttrack.h"
#include "core/grade/redrawing.h"

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
    /// from sample to sample.
    void storeFloors(std::vector<WholeLevels> &levels, std::size_t channel) const
    {
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

/// What half of the width holds is stepped in it, which takes a fraction of the time.
inline void storeFloors(const ExactRamp<Int128> &ramp, std::vector<WholeLevels> &levels,
                        std::size_t channel)
{
    ramp.storeFloors(levels, channel);
}

inline void storeFloors(const ExactRamp<Int256> &ramp, std::vector<WholeLevels> &levels,
                        std::size_t channel)
{
    static const Int256 half = Int256(1) << 125;
    const bool isHeld
        = absolute(ramp.first) < half && absolute(ramp.step) < half && ramp.denominator < half;
    if (isHeld)
        ExactRamp<Int128>{Int128(ramp.first), Int128(ramp.step), Int128(ramp.denominator)}
            .storeFloors(levels, channel);
    else
        ramp.storeFloors(levels, channel);
}

} // namespace pixelplumb
