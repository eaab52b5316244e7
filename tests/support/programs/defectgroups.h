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
        return u"done to the scene"_s;
    case DefectStage::Drawing:
        return u"done by the drawing"_s;
    case DefectStage::Picture:
        break;
    }
    return u"done to the picture"_s;
}

} // namespace pixelplumb
