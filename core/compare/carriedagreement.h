// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <span>

namespace pixelplumb {

/// How far two runs of one scene agree on a number that its vertices carry besides colour: z, u, v
/// or N.
struct CarriedAgreement {
    std::size_t first = 0, second = 0; ///< indices of the two runs
    QString title = {}; ///< "z", "N_x"
    std::int64_t samples = 0; ///< samples that both have written
    std::int64_t differing = 0;
    double largest = 0; ///< the largest distance, in the number's unit
    std::int64_t x = 0, y = 0; ///< its pixel; meaningful where some samples differ
};

/// The agreement of every pair of runs on every number that both carry; a run may be null. The
/// comparison is exact: numbers agree when they are equal, whatever their types.
std::vector<CarriedAgreement> carriedAgreements(
    const std::vector<std::shared_ptr<const TracedScene>> &runs);

/// "z: 1240 of 1320 samples differ, by up to 1.2e-07 at (12, 7)"
QString textOf(const CarriedAgreement &agreement);

} // namespace pixelplumb
