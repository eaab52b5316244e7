// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"
#include "core/scene/scene.h"

#include <QByteArray>

namespace pixelplumb {

/// A scene for programs that read no JSON (resources/student-program.md): a line for the frame,
/// its origin, its background and the fill rule, then one a triangle, in the order of drawing.
/// Coordinates are exact decimals, and pixel (x, y) is the sample at (x, y). An error where it
/// holds more than triangles.
Result<QByteArray> sceneLines(const Scene &scene);

} // namespace pixelplumb
