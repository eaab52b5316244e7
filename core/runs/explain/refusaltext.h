// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/oracle/oracle.h"
#include "core/runs/tracedscene.h"

#include <span>

namespace pixelplumb {

/// A number whose sign decides about a sample.
struct SampleDecision {
    QString title; ///< "E₀"
    Quantity value;
};

/// The decisions among the numbers of a sample.
std::vector<SampleDecision> decisionsOf(const std::vector<NumberDescription> &columns,
                                        const SampleRecord &sample);

/// Which tests keep a sample of a triangle out, in one sentence: negative values, or the edge on
/// which it lies and that edge's owner.
QString refusalSentence(const TracedScene &traced, std::size_t triangle, const SampleRecord &sample,
                        std::span<const SampleDecision> decisions);

/// Who owns an edge that a sample lies exactly on, and by which rule, to be read after the edge's
/// name. The edge accepts the sample only under a rule that gives an edge to one of its sides.
QString tieText(const TracedScene &traced, std::size_t triangle, const oracle::EdgeVerdict &edge,
                std::int64_t x, std::int64_t y);

/// Says that a triangle whose pixels have several samples has none of a pixel; empty if they have
/// one.
QString noPartText(const TracedScene &traced);

} // namespace pixelplumb
