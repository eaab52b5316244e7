// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/scan/linebugs.h"

namespace pixelplumb {

/// The choice of how lines are treated according to where their ends are.
inline constexpr const char *lineEndsChoice = "line ends";

/// Mistakes in the lines of a scene: in p and in the steps of Bresenham's, in the pixels of any
/// method's.
std::vector<Defect> lineDefectsFor(const Scene &scene);

/// A mistake of a program that draws lines, and its texts.
struct LineRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant; ///< without its full stop, where steps may begin at either end
    LineBugs bugs;
};

/// Mistakes in Bresenham's decision: what p begins with, what is added to it, when, and where it
/// steps across. Steps may begin at a line's first end or at its left one.
const std::vector<LineRow> &lineDecisionRows();
/// Mistakes in where his steps lead, how many there are and in the colours, from either end.
const std::vector<LineRow> &lineStepRows();
/// Those that begin at one end, with loops that only go up along the line.
const std::vector<LineRow> &lineEndRows();
/// Mistakes in the pixels that any method's steps lead to.
const std::vector<LineRow> &linePixelRows();

} // namespace pixelplumb
