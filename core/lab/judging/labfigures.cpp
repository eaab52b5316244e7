// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/labfigures.h"

#include <cmath>

namespace pixelplumb {

double MissHistogram::lowerEnd(std::size_t bin)
{
    static constexpr std::array<double, bins> ends
        = {0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 100};
    return ends[bin];
}

std::size_t MissHistogram::binOf(double distance)
{
    std::size_t bin = bins - 1;
    while (bin > 0 && distance < lowerEnd(bin))
        --bin;
    return bin;
}

} // namespace pixelplumb
