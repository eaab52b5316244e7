// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/budget.h"

namespace pixelplumb {

/// A place in the published order.
struct CostOrderEntry {
    const char *contender; ///< id
    double nanosecondsPerPixel; ///< as measured once, for the reader; nothing is computed from it
};

/// The contenders from the cheapest to the dearest, as they were measured once in a release build
/// and as the man page prints them. It is fixed, so that what is chosen by it does not depend on
/// the machine.
std::span<const CostOrderEntry> costOrder();

/// What the order's first contender that meets a budget of errors on a scene is, and why.
struct CostOrderChoice {
    const LabContender *contender = nullptr; ///< null where nobody meets it
    BudgetGround ground = BudgetGround::Nobody;
    QString reason;
    ScanSettings settings; ///< the scene's rule and rounding
};

/// By proof where there is one, else by drawing the scene's triangles and counting what is wrong of
/// the finished picture, which is the same on every machine. The budget is not one of time. None
/// where the listener ended it.
std::optional<CostOrderChoice> firstInOrder(Budget budget, const Scene &scene,
                                            const ProgressListener &listener = {});

} // namespace pixelplumb
