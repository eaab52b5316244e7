// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"
#include "core/grade/redrawing.h"

namespace pixelplumb {

/// Mistakes of a program that walks along edges, in what it divides, adds and rounds. Of one that
/// goes by rows those along edges are there twice, for rows may be gone through from either end,
/// and what an edge has too little of shows at the other end then.
std::vector<Defect> walkDefectsFor(SpanAxis axis);

/// What programs do otherwise with an edge along a span, in which order they take its vertices and
/// from where to where they draw it: what a right program draws does not depend on it, what a wrong
/// one draws may.
std::vector<Defect> flatEdgeChoicesFor(SpanAxis axis);

/// What was done in a variant of the scan, for the assistant.
QString sentenceOf(Variant variant, SpanAxis axis);

/// A redrawing as a defect; in the words `%1` is its span, `%2` the coordinate of its spans, `%3`
/// the other one and `%4` the lower bound.
Defect redrawnDefect(const QString &id, const QString &forStudent, const QString &forAssistant,
                     const Redrawing &redrawing, SpanAxis axis);

} // namespace pixelplumb
