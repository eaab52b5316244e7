// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>

/// What the points of a face's stages are called, and the numbers of one in the formulas of
/// another.
namespace pixelplumb {

/// "V₀": the name of a face's vertex; "C₀": of a clipped polygon's corner.
QString faceVertexName(std::size_t vertex);
QString clippedCornerName(std::size_t corner);

/// The points that have the camera's own numbers, those of the lights and the face's own normal.
QString cameraPointName();
QString lightsPointName();
QString facePointName();
/// Whether a point is one of these, whose numbers every point's formulas may name.
bool isShared(const QString &point);

/// "V₁_y", "V₁_base_R": a number of a vertex in space, as the formulas of other points call it.
QString ofVertex(std::size_t vertex, const QString &number);

/// "x_V₁", "R_V₁": a clip coordinate of a vertex, its level or its place in the texture, as the
/// polygon's formulas call it.
QString clipName(QChar coordinate, std::size_t vertex);

} // namespace pixelplumb
