// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/depthquestion.h"
#include "core/plan/needstally.h"

namespace pixelplumb {

/// Why an effect is called for or not: one clause in a student's words, with numbers from the
/// tally. For all effects but depth, of which it is told only where no triangle is drawn.
QString effectReason(Effect effect, const NeedsTally &tally, const Primitives &primitives,
                     const SampledFrame &where);

/// Why antialiasing is called for or not.
QString antialiasingReason(const Primitives &primitives, const NeedsTally &tally);

/// Why blending is called for or not.
QString blendingReason(const Primitives &primitives, const NeedsTally &tally,
                       const SampledFrame &where);

/// Why depth is called for or not, where the scene leaves the question to the plan.
QString depthReason(const DepthAnswer &answer, const SampledFrame &where);

/// "the triangle has", "1 of 3 triangles has", "both triangles have",
/// "all 3 triangles have".
QString countedWords(std::size_t count, std::size_t all, const QString &noun,
                     const QString &singularVerb, const QString &pluralVerb);

/// Limits a statement about all or none to what is drawn, where some primitives are not.
QString amongDrawn(const NeedsTally &tally);

/// Qualifies a statement about vertices: a triangle without area is drawn as a segment or a point.
QString ofEnds(const NeedsTally &tally);

} // namespace pixelplumb
