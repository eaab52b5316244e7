// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/budget.h"

namespace pixelplumb {

/// A place in the published order.
struct CostOrderEntry {
    const char *contender; ///< id
    double nanosecondsPerPixel; ///< as measured once, for the reader; nothing is computed from it
};

/// The contenders from the cheapest to the most expensive, as measured once in a release build and
/// as the man page prints them. The order is fixed, so that a choice by it does not depend on the
/// machine.
std::span<const CostOrderEntry> costOrder();

/// The order's first contender that meets a budget of errors on a scene, and why.
struct CostOrderChoice {
    const LabContender *contender = nullptr; ///< null if none meets it
    BudgetGround ground = BudgetGround::Nobody;
    QString reason;
    ScanSettings settings; ///< the scene's rule and rounding
};

/// Decides by proof if there is one, else by drawing the scene's triangles and counting the wrong
/// pixels of the finished picture, which is the same on every machine. The budget must not be one
/// of time. None if the listener ended it.
std::optional<CostOrderChoice> firstInOrder(Budget budget, const Scene &scene,
                                            const ProgressListener &listener = {});

} // namespace pixelplumb
