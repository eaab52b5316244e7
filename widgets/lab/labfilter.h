// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labresults.h"

#include <memory>
#include <set>

namespace pixelplumb {

/// The contenders left out of charts and table.
struct LabFilter {
    std::set<Arithmetic> arithmetics;
    std::set<LabKernel> kernels;
    std::set<QString> methods; ///< ids
    enum class StraightLoops { Shown, LeftOut } straightLoops = StraightLoops::Shown;

    bool leavesNobodyOut() const { return *this == LabFilter(); }
    /// By the contender's id.
    bool leavesOut(const QString &contender) const;

    friend bool operator==(const LabFilter &, const LabFilter &) = default;
};

/// The results without the contenders left out.
std::shared_ptr<const Study> filtered(const std::shared_ptr<const Study> &results,
                                      const LabFilter &filter);

} // namespace pixelplumb
