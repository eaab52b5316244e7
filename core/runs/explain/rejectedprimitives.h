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

/// Why a recorded run drew nothing of a primitive that its method rejected; for one without a
/// sample in the frame, whether it lies outside it or reaches into it. None for any other.
std::optional<Rejection> rejectionOf(const TracedScene &traced, std::size_t primitive);

/// What the run's method rejects, in drawing order, without a recording. It runs the kernel
/// itself, primitive by primitive, and stops it before it writes the first pixel; for a triangle
/// between the samples the kernel tries all of them.
std::vector<RejectedPrimitive> rejectedPrimitives(const SceneRun &run);

/// What was rejected in a recorded run, and which triangles lie between the samples.
std::vector<RejectedPrimitive> rejectedPrimitives(const TracedScene &traced);

} // namespace pixelplumb
