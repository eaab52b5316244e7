// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// The group of a defect: the choice it belongs to, or else the stage at which it acts.
inline QString groupOf(const Defect &defect)
{
    if (!defect.choice.isEmpty())
        return defect.choice;
    switch (defect.stage()) {
    case DefectStage::Scene:
        return QStringLiteral("done to the scene");
    case DefectStage::Drawing:
        return QStringLiteral("done by the drawing");
    case DefectStage::Picture:
        break;
    }
    return QStringLiteral("done to the picture");
}

} // namespace pixelplumb
