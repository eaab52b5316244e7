// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <array>
#include <vector>

namespace pixelplumb {

/// A triangle with three vertex colours, no channel of which is 0 or 255.
Triangle coloured(const std::array<LatticePoint, 3> &points);
/// A scene with a frame of 40 × 40 px.
Scene sceneWith(std::vector<Triangle> triangles, const char *method = "column-scan");
/// Three scenes that together separate defects one scene cannot; one has two triangles with a
/// shared edge.
std::vector<Scene> probeScenes(const char *method = "column-scan");
/// The scenes in resources/probes/ that tell all known defects of the method apart.
std::vector<Scene> probeSheet(const QString &method);

} // namespace pixelplumb
