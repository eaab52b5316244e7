// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/programedgetest.h"
#include "core/grade/scan/programwalk.h"

namespace pixelplumb {

std::optional<Redrawing> together(const Redrawing &one, const Redrawing &other)
{
    const auto findsSamples
        = [](const Redrawing &each) { return each.walk != nullptr || each.edgeTest != nullptr; };
    if (findsSamples(other) && !findsSamples(one))
        return together(other, one);
    // A program finds its samples in one way.
    const bool areTwoWays = (one.walk && other.edgeTest) || (one.edgeTest && other.walk);
    if (areTwoWays)
        return std::nullopt;
    const bool isWrapping
        = one.overflow == LevelOverflow::Wraps || other.overflow == LevelOverflow::Wraps;
    const auto overflow = isWrapping ? LevelOverflow::Wraps : LevelOverflow::Clamps;
    // A walk rounds its own levels, as does a program with other weights of colours.
    const auto weighs
        = [](const Redrawing &each) { return each.edgeTest && each.edgeTest->changesColours(); };
    const bool roundsItself = one.walk || weighs(one) || weighs(other);
    const bool areTwoRoundings = (roundsItself || !one.bytes.isRight()) && !other.bytes.isRight();
    if (areTwoRoundings)
        return std::nullopt;
    Redrawing both;
    if (one.walk && other.walk) {
        const auto walk = together(*one.walk, *other.walk);
        if (!walk)
            return std::nullopt;
        both = redrawingBy(*walk);
    } else if (one.edgeTest && other.edgeTest) {
        const auto tests = together(*one.edgeTest, *other.edgeTest);
        if (!tests)
            return std::nullopt;
        both = redrawingByTests(*tests);
    } else {
        both = {[one, other](TriangleRuns &triangle) {
                    one.change(triangle);
                    other.change(triangle);
                },
                overflow};
        both.findsSamples = one.findsSamples;
    }
    const bool isToggling
        = one.repainting == Repainting::Toggles || other.repainting == Repainting::Toggles;
    both.repainting = isToggling ? Repainting::Toggles : Repainting::Over;
    if (!both.edgeTest)
        both.edgeTest = one.edgeTest;
    both.box = one.box == VisitedBox::OfScene ? other.box : one.box;
    both.bytes = one.bytes.isRight() ? other.bytes : one.bytes;
    return both;
}

} // namespace pixelplumb
