// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>

/// The names of the points of a face's stages, and of their numbers in the formulas of other
/// points.
namespace pixelplumb {

/// "V₀" names a face's vertex, "C₀" a corner of the clipped polygon.
QString faceVertexName(std::size_t vertex);
QString clippedCornerName(std::size_t corner);

/// The points that hold the camera's own numbers, the lights' and the face's own normal.
QString cameraPointName();
QString lightsPointName();
QString facePointName();
/// Whether a point is one of these, whose numbers may appear in any point's formulas.
bool isShared(const QString &point);

/// "V₁_y", "V₁_base_R": a number of a vertex in space, as named in the formulas of other points.
QString ofVertex(std::size_t vertex, const QString &number);

/// "x_clip_V₁", "R_V₁": a number of a vertex before clipping, as named in the polygon's formulas.
QString clipName(const QString &number, std::size_t vertex);

} // namespace pixelplumb
