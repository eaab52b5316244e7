// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationcounts.h"

#include <QString>

#include <vector>

namespace pixelplumb {

/// What every résumé is counted on if there is no scene, so that methods of one kind can be
/// compared: it shows what a rectangle, increments or active edges save.
struct StandardExample {
    QString name; ///< "the triangle (4, 5) (58, 12) (53/2, 44) in 64 × 48"
    Primitives primitives;
};

/// For the kind that the method draws first; a triangle is followed by a small one, to show the
/// share of its set-up.
std::vector<StandardExample> standardExamplesFor(const Method &method);

/// Counts on an example, in its frame of 64 × 48 pixels, under the closed rule or the method's
/// first one.
std::optional<OperationCounts> countOperations(const Method &method, Arithmetic arithmetic,
                                               const StandardExample &example);

} // namespace pixelplumb
