// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <QString>

#include <functional>
#include <vector>

namespace pixelplumb {

/// A mistake that programs make, as something done to the scene before it is drawn by the ordinary
/// kernels (the variants and the choices of its settings among them) or to the finished picture.
struct Defect {
    QString id; ///< "unsorted-colours"
    QString forStudent; ///< where to look, without the answer
    QString forAssistant; ///< what was done
    /// False where it does not apply: the method cannot be drawn so, or nothing is changed.
    std::function<bool(Scene &scene)> changeScene = {};
    /// Where it is no scene's: of the picture that is right but for what is done to the scene.
    std::function<Picture(const Picture &right, const Scene &scene)> changePicture = {};
    bool standsAlone = false; ///< is not looked for beside another
    QString choice = {}; ///< of defects of one choice only one can be there; empty: of none

    bool isOfPicture() const { return bool(changePicture); }
};

/// Those that a scene's method can have, in the order in which they are tried. Pictures of one size
/// with that background are changed.
std::vector<Defect> defectsFor(const Scene &scene);

} // namespace pixelplumb
