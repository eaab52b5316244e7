// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace pixelplumb::bench {

/// The middle of a sample and where its middle half lies.
struct Quartiles {
    double first = 0;
    double median = 0;
    double third = 0;
};

/// Linear interpolation between the two nearest ranks; all zero for no values.
inline Quartiles quartilesOf(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        const double rank = share * double(values.size() - 1);
        const auto below = std::size_t(rank);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        return values[below] + (rank - double(below)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

} // namespace pixelplumb::bench
