// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "tests/support/framespec.h"

#include <QRandomGenerator>

/// Shared helpers of the line and curve tests: shapes in short, and their pictures.
namespace pixelplumb {

Shape lineAtUnits(LatticePoint a, LatticePoint b);
/// A line between whole-pixel end points.
Shape lineAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1);

Shape ellipseAtUnits(LatticePoint centre, Lattice radiusX, Lattice radiusY,
                     ShapeFill fill = ShapeFill::Outline);
Shape circleAt(std::int64_t x, std::int64_t y, std::int64_t radius,
               ShapeFill fill = ShapeFill::Outline);

/// A Bézier curve with three or four control points.
Shape bezierAt(const std::vector<LatticePoint> &controls);
/// A random Bézier curve within 60 × 60 px, at multiples of `step` lattice units.
Shape randomCurve(QRandomGenerator &random, Lattice step);

Scene sceneOf(const Shape &shape, const char *method, const FrameSpec &spec);

CasePicture pictureBy(QStringView method, const Shape &shape, const FrameSpec &spec,
                      Arithmetic arithmetic = Arithmetic::Exact);
CasePicture truthOf(const Shape &shape, const FrameSpec &spec);

/// `#` written, `.` not; the highest row first.
QString textOf(const CasePicture &picture);

/// The difference, such as "3 pixels missing"; empty if two pictures are the same.
QString departure(const CasePicture &drawn, const CasePicture &truth);

/// Whether the picture has no gaps: each pixel but one has a neighbour in it.
bool isConnected(const CasePicture &picture);

/// The vertices in lattice units, for messages.
QString nameOf(const Shape &shape);

} // namespace pixelplumb
