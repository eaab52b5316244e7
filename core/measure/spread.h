// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace pixelplumb {

/// The middle of repeated measurements and their spread: the mean says little if a few samples were
/// disturbed.
struct Spread {
    double lower = 0; ///< a quarter of the samples is below
    double median = 0;
    double upper = 0; ///< a quarter is above

    friend bool operator==(const Spread &, const Spread &) = default;
};

/// Of at least one sample; interpolates between neighbouring ones.
inline Spread spreadOf(std::vector<double> samples)
{
    std::ranges::sort(samples);
    const auto at = [&](double share) {
        const double place = share * double(samples.size() - 1);
        const auto below = std::size_t(place);
        const std::size_t above = std::min(below + 1, samples.size() - 1);
        return samples[below] + (samples[above] - samples[below]) * (place - double(below));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

/// In another unit: ns a pixel in place of ns a draw.
inline Spread scaled(const Spread &spread, double factor)
{
    return {spread.lower * factor, spread.median * factor, spread.upper * factor};
}

} // namespace pixelplumb
