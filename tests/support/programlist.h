// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/mistakenprograms.h"

namespace pixelplumb {

/// Programs with mistakes, named after the defects.
class ProgramList {
public:
    using Mistakes = std::set<WalkMistake>;

    /// Edge mistakes: by columns, and by rows from either end.
    void addOfEdges(const char *id, Mistakes mistakes)
    {
        add(id, mistakes, "column-scan", "edges");
        add(id, mistakes, "row-walk", "edges");
        mistakes.insert(WalkMistake::FromBelow);
        add(qPrintable(QString::fromLatin1(id) + QStringLiteral("-from-below")), mistakes,
            "row-walk", "edges from below");
    }
    void addOfColumns(const char *id, const Mistakes &mistakes)
    {
        add(id, mistakes, "column-scan", "edges");
    }
    /// Span mistakes: the direction in which the spans are visited does not matter.
    void addOfSpans(const char *id, const Mistakes &mistakes)
    {
        add(id, mistakes, "column-scan", "spans");
        add(id, mistakes, "row-walk", "spans");
    }
    /// Mistakes at the ends. From above, the last row is the one with the least y.
    void addOfEnds(const char *id, const char *fromAbove, Mistakes mistakes)
    {
        add(id, mistakes, "column-scan", "ends");
        add(fromAbove, mistakes, "row-walk", "ends");
        mistakes.insert(WalkMistake::FromBelow);
        add(id, mistakes, "row-walk", "ends from below");
    }

    /// Mistakes at the ends for which it matters where the program starts.
    void addOfEndsInOrder(const char *id, const char *fromAbove, const char *fromBelow,
                          Mistakes mistakes)
    {
        add(id, mistakes, "column-scan", "ends");
        add(fromAbove, mistakes, "row-walk", "ends");
        mistakes.insert(WalkMistake::FromBelow);
        add(fromBelow, mistakes, "row-walk", "ends from below");
    }

    std::vector<MistakenProgram> all;

private:
    void add(const char *id, const Mistakes &mistakes, const char *method, const char *of)
    {
        all.push_back({QString::fromLatin1(method), QString::fromLatin1(id), mistakes,
                       QStringLiteral("%1, %2").arg(QLatin1String(method), QLatin1String(of))});
    }
};

/// Values taken from another edge or channel, and mistakes in the colours alone.
void addOfOtherRates(ProgramList &programs);
void addOfEdgeColours(ProgramList &programs);
void addOfSpanColours(ProgramList &programs);

} // namespace pixelplumb
