// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/mistakenprograms.h"

namespace pixelplumb {

/// Programs with mistakes, by the names of these.
class ProgramList {
public:
    using Mistakes = std::set<WalkMistake>;

    /// Mistakes that go by columns and, from either end, by rows.
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
    /// Of spans, where it does not matter from which end they are gone through.
    void addOfSpans(const char *id, const Mistakes &mistakes)
    {
        add(id, mistakes, "column-scan", "spans");
        add(id, mistakes, "row-walk", "spans");
    }
    /// From above the last row is that of the least y.
    void addOfEnds(const char *id, const char *fromAbove, Mistakes mistakes)
    {
        add(id, mistakes, "column-scan", "ends");
        add(fromAbove, mistakes, "row-walk", "ends");
        mistakes.insert(WalkMistake::FromBelow);
        add(id, mistakes, "row-walk", "ends from below");
    }

    /// The same where it matters at which end they begin.
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

/// What takes something of another edge or channel, and what is wrong in the colours alone.
void addOfOtherRates(ProgramList &programs);
void addOfEdgeColours(ProgramList &programs);
void addOfSpanColours(ProgramList &programs);

} // namespace pixelplumb
