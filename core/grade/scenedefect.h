// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

namespace pixelplumb {

/// Mistakes in what is drawn, by kernels that are right: where vertices and samples are, which
/// colour a vertex has, which primitives are drawn and in which order.
std::vector<Defect> sceneDefectsFor(const Scene &scene);

/// Adds a defect of the scene, one of a choice, where the scene can have it.
void appendWhereItApplies(std::vector<Defect> &defects, const Scene &scene, const QString &choice,
                          Defect defect);

} // namespace pixelplumb
