// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "core/scene/text/result.h"

#include <QByteArray>

namespace pixelplumb {

/// A scene as text for programs that read no JSON (resources/student-program.md): a line for the
/// frame, its origin, its pixel centres, its background and the fill rule, then one for each
/// triangle, in drawing order. Coordinates are exact decimals, as the scene has them. An error
/// where the scene has more than triangles.
Result<QByteArray> sceneLines(const Scene &scene);

} // namespace pixelplumb
