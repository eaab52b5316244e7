// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <vector>

namespace pixelplumb {

/// A primitive of which a method draws nothing, and why.
struct RejectedPrimitive {
    std::size_t primitive = 0; ///< index in the primitives
    PrimitiveKind kind = PrimitiveKind::Triangle;
    Rejection rejection = PrimitiveRejection::ZeroArea;

    /// "primitive 3 (polygon): It is not convex: …"
    QString message() const;

    friend bool operator==(const RejectedPrimitive &, const RejectedPrimitive &) = default;
};

/// Why a recorded run drew nothing of a primitive: what its method rejects it for, or where it lies
/// if it has no sample in the frame. None for one that was drawn, is hidden by others, or is not
/// recorded to its end.
std::optional<Rejection> rejectionOf(const TracedScene &traced, std::size_t primitive);

/// The primitives of which the run's method draws nothing, in drawing order, without a recording:
/// the kernel itself draws each alone, up to the first pixel that it writes.
std::vector<RejectedPrimitive> rejectedPrimitives(const SceneRun &run);

/// The same primitives of a recorded run, as far as it is recorded.
std::vector<RejectedPrimitive> rejectedPrimitives(const TracedScene &traced);

} // namespace pixelplumb
