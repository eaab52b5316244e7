// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picturecause.h"
#include "core/grade/pictures/picturerange.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

struct LineBugs;
struct Redrawing;

/// When a defect takes effect; of two the one with the earlier stage comes first.
enum class DefectStage { Scene, Drawing, Picture };

/// The choice of arithmetic, which is no mistake where the tolerance allows it.
inline constexpr const char *arithmeticChoice = "arithmetic";
/// The choice of which edges own the samples on them.
inline constexpr const char *ruleChoice = "rule";
/// The choice of how a level is rounded to a byte.
inline constexpr const char *roundingChoice = "rounding";

/// Whether two of the departures cancel: a division by Δ − 1 and by Δ + 1 make one by Δ.
constexpr bool undoEachOther(VariantSet departures)
{
    return departures.contains(Variant::DivisorMinusOne)
        && departures.contains(Variant::DivisorPlusOne);
}

/// The sentence about these two.
QString undoingText();

/// A mistake that programs make, as a change of the scene before the ordinary kernels draw it
/// (including its settings and their variants), of how it is drawn, or of the finished picture.
struct Defect {
    QString id; ///< "unsorted-colours"
    QString forStudent; ///< where to look, without giving the answer
    QString forAssistant; ///< what was done
    /// False where it does not apply: the method cannot be drawn so, or nothing changes.
    std::function<bool(Scene &scene)> changeScene = {};
    /// Set where no kernel draws so: our own program draws the scene with the mistake.
    std::function<Picture(const Scene &scene)> redraw = {};
    /// Set for a mistake in the finished picture: a pixel of it, for a scene with that background.
    PixelRule changePicture = {};
    bool standsAlone = false; ///< never combined with another
    QString choice = {}; ///< at most one defect of each choice is present; empty: of none
    /// What programs with other rounding redraw; missing where unknown.
    std::function<PictureRange(const Scene &scene, Arithmetic arithmetic)> redrawRange = {};
    /// The change of each triangle; two defects that have one can be combined.
    std::shared_ptr<const Redrawing> redrawing = {};
    /// The bugs of the lines' program that draws so; two defects that have some can be combined.
    std::shared_ptr<const LineBugs> lines = {};
    bool leavesOut = false; ///< it only draws less of a scene; what it draws is right
    bool isRightAlone = false; ///< alone it is no mistake, so it is tried only with another
    bool movesPixels = false; ///< it takes pixels of the finished picture from other places

    DefectStage stage() const
    {
        if (changePicture)
            return DefectStage::Picture;
        return redraw ? DefectStage::Drawing : DefectStage::Scene;
    }
};

/// A defect that is a redrawing of triangles.
Defect redrawnBy(const Redrawing &redrawing, Defect words);

/// A defect that is a program of lines.
Defect drawnLinesBy(const LineBugs &bugs, Defect words);

/// Both, drawn by one program; none where they change the same decision.
std::optional<Defect> drawnTogether(const Defect &one, const Defect &other);

/// Whether a program can have both: not two of one choice, nor two that change the same decision.
bool canBeTogether(const Defect &one, const Defect &other);

/// The defects that a scene's method can have, in the order in which they are tried.
std::vector<Defect> defectsFor(const Scene &scene);

/// The defects that scenes with these conventions can have: a method, settings, origin and pixel
/// centre. Their primitives do not matter.
std::vector<Defect> defectsUnder(const Scene &conventions);

/// The defects in the version of one scene: those of `known`, that scene's list, with the ids of
/// `defects`. A defect found for other scenes, perhaps with other methods, may be missing there and
/// leaves the scene unchanged.
std::vector<Defect> ownDefects(std::span<const Defect> known, std::span<const Defect> defects);

} // namespace pixelplumb
