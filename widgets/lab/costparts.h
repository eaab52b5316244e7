// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb {

/// What a pixel of a family costs, ns, split into the set-up of its triangle, its column or row,
/// and itself. The parts come from the fit over all families, so that the sum is near the measured
/// time, not equal.
struct CostParts {
    double setUp = 0;
    double columns = 0;
    double pixels = 0;

    double sum() const { return setUp + columns + pixels; }

    friend bool operator==(const CostParts &, const CostParts &) = default;
};

/// None where the contender or the family was not timed.
std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row);

} // namespace pixelplumb
