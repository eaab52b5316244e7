// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/projection.h"
#include "core/space/stagenames.h"

#include <QString>

namespace pixelplumb {

/// A number of a stage: the value used, and the value of the same code without rounding.
struct StageNumber {
    QString name; ///< "x", "z_clip"; an underscore makes what follows a subscript
    double used = 0;
    QString exact; ///< 20 digits; empty where no unrounded value exists
    double error = 0; ///< used − exact; NaN where there is no exact value
    /// How it is computed, by the names of the numbers of this point and of the camera; a prime
    /// marks a number of the same name from the previous stage: "x_clip/w". Empty for a given
    /// number.
    QString formula = {};
};

/// A vertex V₀, V₁, … of the face, a corner C₀, C₁, … of its clipped polygon, or the face's centre.
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

/// All stages of one face, recomputed by the code that draws.
struct FaceStages {
    std::vector<ProjectionStage> stages;
    ProjectedFace<double> face; ///< as used for drawing
    std::vector<SnappedCorner> corners; ///< of the clipped polygon, as the kernels get them
};

/// The stages of a face. `source` names the face; its piece is ignored.
FaceStages stagesOf(const SpaceScene &scene, const TriangleSource &source, int wExponent);

} // namespace pixelplumb
