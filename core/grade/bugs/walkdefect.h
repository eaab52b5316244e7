// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/grade/scan/redrawing.h"

namespace pixelplumb {

/// Mistakes of a program that walks along edges, in what it divides, adds and rounds. For a program
/// that goes by rows, mistakes along edges are listed twice, since rows may be visited from either
/// end, and an edge's error then shows at the other end.
std::vector<Defect> walkDefectsFor(SpanAxis axis);

/// Choices for an edge along a span: in which order its vertices are taken and from where to where
/// it is drawn. They make no difference in a right program, but may in a wrong one.
std::vector<Defect> flatEdgeChoicesFor(SpanAxis axis);

/// What a variant of the scan does, for the assistant.
QString sentenceOf(Variant variant, SpanAxis axis);

/// A redrawing as a defect; in its texts `%1` is a span, `%2` the coordinate of the spans, `%3` the
/// other one and `%4` the lower bound.
Defect redrawnDefect(const QString &id, const QString &forStudent, const QString &forAssistant,
                     const Redrawing &redrawing, SpanAxis axis);

} // namespace pixelplumb
