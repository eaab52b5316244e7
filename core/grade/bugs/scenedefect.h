// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// Mistakes in what is drawn, while the kernels are right: positions of vertices and samples,
/// colours of vertices, which primitives are drawn and in which order.
std::vector<Defect> sceneDefectsFor(const Scene &scene);

/// Adds a defect of the scene, which belongs to a choice, if the scene can have it.
void appendWhereItApplies(std::vector<Defect> &defects, const Scene &scene, const QString &choice,
                          Defect defect);

} // namespace pixelplumb
