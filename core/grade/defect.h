// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picturerange.h"

#include <QString>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pixelplumb {

struct Redrawing;

/// When a defect does its work: of two the one that is earlier does it first.
enum class DefectStage { Scene, Drawing, Picture };

/// The choice of what is computed in, which is no mistake where it is allowed for.
inline constexpr const char *arithmeticChoice = "arithmetic";
/// The choice of which edges own the samples on them.
inline constexpr const char *ruleChoice = "rule";
/// The choice of how a level is rounded to a byte.
inline constexpr const char *roundingChoice = "rounding";

/// Whether two of the departures undo each other: divided is by Δ − 1 and one more, by Δ.
constexpr bool undoEachOther(VariantSet departures)
{
    return departures.contains(Variant::DivisorMinusOne)
        && departures.contains(Variant::DivisorPlusOne);
}
/// What is said of these two.
QString undoingText();

/// A mistake that programs make, as something done to the scene before it is drawn by the ordinary
/// kernels (the variants and the choices of its settings among them), to how it is drawn, or to the
/// finished picture.
struct Defect {
    QString id; ///< "unsorted-colours"
    QString forStudent; ///< where to look, without the answer
    QString forAssistant; ///< what was done
    /// False where it does not apply: the method cannot be drawn so, or nothing is changed.
    std::function<bool(Scene &scene)> changeScene = {};
    /// Where no kernel draws so: the scene drawn by a program of ours that does.
    std::function<Picture(const Scene &scene)> redraw = {};
    /// Where it is neither's: done to the finished picture of a scene with that background.
    std::function<Picture(const Picture &right, const Colour &background)> changePicture = {};
    bool standsAlone = false; ///< is not looked for beside another
    QString choice = {}; ///< of defects of one choice only one can be there; empty: of none
    /// What is redrawn by programs that round otherwise; left out where nobody knows.
    std::function<PictureRange(const Scene &scene, Arithmetic arithmetic)> redrawRange = {};
    /// Of triangles, as what is done to them one by one: two of these can be done together.
    std::shared_ptr<const Redrawing> redrawing = {};
    bool leavesOut = false; ///< of a scene it draws less, and what it draws is right
    bool isRightAlone = false; ///< is looked for beside another only: alone it is no mistake

    DefectStage stage() const
    {
        if (changePicture)
            return DefectStage::Picture;
        return redraw ? DefectStage::Drawing : DefectStage::Scene;
    }
};

/// A defect that is a redrawing of triangles.
Defect redrawnBy(const Redrawing &redrawing, Defect words);

/// Whether a program can have both: not two of one choice, nor two that decide the same otherwise.
bool canBeTogether(const Defect &one, const Defect &other);

/// Those that a scene's method can have, in the order in which they are tried.
std::vector<Defect> defectsFor(const Scene &scene);

/// The same defects as one scene has them: those of `known`, the list of that scene, with the ids
/// of `defects`. What was found for other scenes, of other methods perhaps, may be none of this
/// one's and leaves it as it is.
std::vector<Defect> ownDefects(std::span<const Defect> known, std::span<const Defect> defects);

} // namespace pixelplumb
