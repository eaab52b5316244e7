// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <QByteArray>

/// Shared helpers of the tests of scenes with primitives other than triangles.
namespace pixelplumb {

/// A scene of 8 × 8 pixels with these primitives from line 3 on, and these members before them.
QByteArray sceneOfPrimitives(const QByteArray &primitives, const QByteArray &members = {});

/// JSON with apostrophes as quotation marks: moc cannot parse raw strings that contain a #.
QByteArray json(const char *text);

/// One shape of each kind, and its line in a file.
struct ShapeExample {
    QByteArray text;
    Shape shape;
};
std::vector<ShapeExample> shapeExamples();

} // namespace pixelplumb
