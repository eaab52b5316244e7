// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <array>
#include <vector>

namespace pixelplumb {

/// Each vertex in another colour, no channel of which is at its bounds.
Triangle coloured(const std::array<LatticePoint, 3> &points);
/// In a frame of 40 × 40 px.
Scene sceneWith(std::vector<Triangle> triangles, const char *method = "column-scan");
/// Three scenes that part what one does not, two triangles in one of them with a shared edge.
std::vector<Scene> probeScenes(const char *method = "column-scan");
/// Those in resources/probes/ that tell all known defects of the method apart.
std::vector<Scene> probeSheet(const QString &method);

} // namespace pixelplumb
