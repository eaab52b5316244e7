// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/programwalk.h"

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

/// Two walks, member by member: what one of them has otherwise than a right one the other leaves
/// as it is.
class WalkMerger {
public:
    WalkMerger(const ProgramWalk &one, const ProgramWalk &other)
        : m_one(one)
        , m_other(other)
    {
        // All members by name: one more does not compile before it has its line here.
        const auto &[order, departures, behindMiddle, slopes, edgeColours, preSteps, steps,
                     edgeLevels, levels, edgeColourStart, spans, first, last, divisor]
            = m_right;
        m_both.order = one.order ? one.order : other.order ? other.order : order;
        takeDepartures(&ProgramWalk::departures, departures);
        takeDepartures(&ProgramWalk::departuresBehindMiddle, behindMiddle);
        take(&ProgramWalk::slopes, slopes);
        take(&ProgramWalk::edgeColours, edgeColours);
        take(&ProgramWalk::preSteps, preSteps);
        take(&ProgramWalk::steps, steps);
        take(&ProgramWalk::edgeLevels, edgeLevels);
        take(&ProgramWalk::levels, levels);
        take(&ProgramWalk::edgeColourStart, edgeColourStart);
        take(&ProgramWalk::spans, spans);
        take(&ProgramWalk::first, first);
        take(&ProgramWalk::last, last);
        take(&ProgramWalk::divisor, divisor);
    }

    std::optional<ProgramWalk> both() const
    {
        return m_isContradiction ? std::nullopt : std::optional(m_both);
    }

private:
    template <class Member>
    void take(Member ProgramWalk::*member, const Member &right)
    {
        const bool isDone = m_one.*member != right;
        if (isDone && m_other.*member != right)
            m_isContradiction = true;
        m_both.*member = isDone ? m_one.*member : m_other.*member;
    }

    /// Several can be there, but not the same in both, nor those that undo each other.
    void takeDepartures(VariantSet ProgramWalk::*member, const VariantSet &right)
    {
        const VariantSet one = m_one.*member;
        const VariantSet other = m_other.*member;
        VariantSet both = right;
        both.bits |= one.bits | other.bits;
        const bool areUndone
            = both.contains(Variant::DivisorMinusOne) && both.contains(Variant::DivisorPlusOne);
        if ((one.bits & other.bits) != 0 || areUndone)
            m_isContradiction = true;
        m_both.*member = both;
    }

    const ProgramWalk m_right;
    const ProgramWalk &m_one, &m_other;
    ProgramWalk m_both;
    bool m_isContradiction = false;
};

/// Whether it matters from which end its spans are gone through.
bool hasOrder(ProgramWalk walk)
{
    const ProgramWalk right;
    // Those of a span alone.
    walk.preSteps = right.preSteps;
    walk.steps = right.steps;
    walk.levels = right.levels;
    walk.first = right.first;
    walk.last = right.last;
    walk.divisor = right.divisor;
    return walk != right;
}

std::optional<ProgramWalk> merged(const ProgramWalk &one, const ProgramWalk &other)
{
    const bool areOpposed = hasOrder(one) && hasOrder(other) && one.order != other.order;
    return areOpposed ? std::nullopt : WalkMerger(one, other).both();
}

/// A walk's levels stay at their samples whatever is left out before them.
void leaveOut(const Redrawing &omission, TriangleRuns &triangle)
{
    std::map<std::int64_t, std::int64_t> firstSamples; // by span
    for (const SampleRun &run : triangle.runs)
        firstSamples[run.span] = run.first;
    omission.change(triangle);
    for (SampleRun &run : triangle.runs) {
        const auto left = std::clamp<std::int64_t>(run.first - firstSamples[run.span], 0,
                                                   std::ssize(run.levels));
        run.levels.erase(run.levels.begin(), run.levels.begin() + left);
    }
}

} // namespace

Redrawing redrawingBy(const ProgramWalk &walk, LevelOverflow overflow)
{
    return {
        walking(walk), overflow, Repainting::Over, {}, std::make_shared<const ProgramWalk>(walk)};
}

std::optional<Redrawing> together(const Redrawing &one, const Redrawing &other)
{
    if (!one.walk && other.walk)
        return together(other, one);
    const bool isWrapping
        = one.overflow == LevelOverflow::Wraps || other.overflow == LevelOverflow::Wraps;
    const auto overflow = isWrapping ? LevelOverflow::Wraps : LevelOverflow::Clamps;
    // A walk rounds the levels that it carries by itself.
    const bool areTwoRoundings = (one.walk || !one.bytes.isRight()) && !other.bytes.isRight();
    if (areTwoRoundings)
        return std::nullopt;
    Redrawing both;
    if (one.walk && other.walk) {
        const auto walk = merged(*one.walk, *other.walk);
        if (!walk)
            return std::nullopt;
        both = redrawingBy(*walk, overflow);
    } else {
        both = {[one, other](TriangleRuns &triangle) {
                    one.change(triangle);
                    leaveOut(other, triangle);
                },
                overflow};
    }
    const bool isToggling
        = one.repainting == Repainting::Toggles || other.repainting == Repainting::Toggles;
    both.repainting = isToggling ? Repainting::Toggles : Repainting::Over;
    both.bytes = one.bytes.isRight() ? other.bytes : one.bytes;
    return both;
}

} // namespace pixelplumb
