// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/projection.h"
#include "core/space/stagenames.h"

#include <QString>

namespace pixelplumb {

/// A number of a stage: what was used, beside what the same code gives without rounding.
struct StageNumber {
    QString name; ///< "x", "z_clip"; an underscore lowers what follows it
    double used = 0;
    QString exact; ///< 20 digits; empty where there is no such number without rounding
    double error = 0; ///< used − exact; NaN where there is none
    /// What it is worked out from, the numbers of this point and of the camera by their names,
    /// those of a stage before under the same name with a prime: "x_clip/w"; empty where it is
    /// given.
    QString formula = {};
};

/// A vertex V₀, V₁, … of the face, a corner C₀, C₁, … of the polygon that clipping makes of it, or
/// the face's centre.
struct StagePoint {
    QString name;
    QString note; ///< "kept: at or beyond the near plane", "cuts V₁V₂"
    std::vector<StageNumber> numbers;
};

/// One stage on the way from space to the frame (Scan Conversion slides, "Projective Rendering
/// Pipeline").
struct ProjectionStage {
    QString title; ///< "Clip coordinates"
    QString formula; ///< "w = −z_view, …"
    std::vector<StagePoint> points;
};

/// The whole way of one face, computed again by the code that draws.
struct FaceStages {
    std::vector<ProjectionStage> stages;
    ProjectedFace<double> face; ///< as it was used
    std::vector<SnappedCorner> corners; ///< of the clipped polygon, as kernels get them
};

/// source: a face of the scene; its piece does not matter.
FaceStages stagesOf(const SpaceScene &scene, const TriangleSource &source, int wExponent);

} // namespace pixelplumb
