// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

namespace pixelplumb {

/// The kind of a defect: what it is a choice of, else when it does its work.
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
