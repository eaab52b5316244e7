// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/linedecision.h"

#include "core/grade/drawnline.h"
#include "core/methods/method.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Of Δx ≥ Δy, along the line and across it, px.
using Term = std::int64_t (*)(std::int64_t dx, std::int64_t dy);

std::int64_t twiceRise(std::int64_t, std::int64_t dy) { return 2 * dy; }
std::int64_t twiceDifference(std::int64_t dx, std::int64_t dy) { return 2 * dy - 2 * dx; }
std::int64_t midpoint(std::int64_t dx, std::int64_t dy) { return 2 * dy - dx; }
std::int64_t difference(std::int64_t dx, std::int64_t dy) { return dy - dx; }

enum class StepsAcross { WherePositive, WhereNegative };

/// What p begins with, what is added where the line stays and where it steps across.
struct Decision {
    Term first = midpoint;
    Term stay = twiceRise;
    Term cross = twiceDifference;
    StepsAcross steps = StepsAcross::WherePositive;
};

/// How far the line has stepped across, px, after so many steps along it.
std::vector<std::int64_t> stepsAcross(const Decision &by, std::int64_t dx, std::int64_t dy,
                                      bool staysAtZero)
{
    std::vector<std::int64_t> across = {0};
    std::int64_t p = by.first(dx, dy);
    while (std::ssize(across) <= dx) {
        const bool isPositive = p > 0 || (p == 0 && !staysAtZero);
        const bool crosses = isPositive == (by.steps == StepsAcross::WherePositive);
        across.push_back(across.back() + (crosses ? 1 : 0));
        p += (crosses ? by.cross : by.stay)(dx, dy);
    }
    return across;
}

void decide(const Decision &by, DrawnLine &line, bool staysAtZero)
{
    const bool isSteep = line.isSteep();
    const auto alongOf = [&](const LatticePoint &point) { return isSteep ? point.y : point.x; };
    const auto acrossOf = [&](const LatticePoint &point) { return isSteep ? point.x : point.y; };
    const auto isOnSample = [](const LatticePoint &point) {
        return point == latticePixel(floorPixel(point.x), floorPixel(point.y));
    };
    if (!isOnSample(line.from) || !isOnSample(line.to))
        return;
    const std::int64_t begin = floorPixel(alongOf(line.from));
    const std::int64_t beside = floorPixel(acrossOf(line.from));
    const std::int64_t rise = floorPixel(acrossOf(line.to)) - beside;
    const auto across = stepsAcross(by, std::abs(floorPixel(alongOf(line.to)) - begin),
                                    std::abs(rise), staysAtZero);
    for (LinePixel &pixel : line.pixels) {
        const std::int64_t steps = std::abs((isSteep ? pixel.y : pixel.x) - begin);
        const std::int64_t rows = across[std::size_t(std::min(steps, std::ssize(across) - 1))];
        (isSteep ? pixel.x : pixel.y) = beside + (rise < 0 ? -rows : rows);
    }
}

struct DecisionRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    Decision decision;
};

constexpr const char *beginQuestion = "How much has the line risen half-way to the next column?";
constexpr const char *stepQuestion
    = "By how much does p change where the line stays in its row, and where it steps out of it?";

const std::vector<DecisionRow> &decisionRows()
{
    static const std::vector<DecisionRow> rows = {
        {"decision-without-dx",
         beginQuestion,
         "The decision begins with 2Δy in place of 2Δy − Δx",
         {.first = twiceRise}},
        {"decision-from-difference",
         beginQuestion,
         "The decision begins with Δy − Δx in place of 2Δy − Δx",
         {.first = difference}},
        {"decision-from-zero",
         beginQuestion,
         "The decision begins with 0 in place of 2Δy − Δx",
         {.first = [](std::int64_t, std::int64_t) -> std::int64_t { return 0; }}},
        {"decision-without-dy",
         beginQuestion,
         "The decision begins with −Δx in place of 2Δy − Δx",
         {.first = [](std::int64_t dx, std::int64_t) { return -dx; }}},
        {"decision-of-exchanged-differences",
         beginQuestion,
         "The decision begins with 2Δx − Δy in place of 2Δy − Δx",
         {.first = [](std::int64_t dx, std::int64_t dy) { return 2 * dx - dy; }}},
        {"decision-stays-by-dy",
         stepQuestion,
         "Where the line stays, Δy is added to p in place of 2Δy",
         {.stay = [](std::int64_t, std::int64_t dy) { return dy; }}},
        {"decision-crosses-by-dx",
         stepQuestion,
         "Where the line steps across, 2Δy − Δx is added to p in place of 2Δy − 2Δx",
         {.cross = midpoint}},
        {"decision-crosses-by-difference",
         stepQuestion,
         "Where the line steps across, Δy − Δx is added to p in place of 2Δy − 2Δx",
         {.cross = difference}},
        {"decision-never-lowered",
         stepQuestion,
         "2Δy is added to p always: where the line steps across, 2Δx is not subtracted",
         {.cross = twiceRise}},
        {"decision-lowered-alone",
         stepQuestion,
         "Where the line steps across, 2Δx is subtracted from p, but 2Δy is not added",
         {.cross = [](std::int64_t dx, std::int64_t) { return -2 * dx; }}},
        {"decision-of-wrong-sign",
         stepQuestion,
         "The line steps across where p < 0, and stays where it is not",
         {.steps = StepsAcross::WhereNegative}},
    };
    return rows;
}

/// At which end steps begin.
enum class LineStart { AtFirstEnd, AtLeftEnd };

Defect defectBy(const DecisionRow &row, LineStart start)
{
    const Decision by = row.decision;
    const bool fromLeft = start == LineStart::AtLeftEnd;
    const auto redraw = [by, fromLeft](const Scene &scene) {
        const bool staysAtZero = scene.settings.variants.contains(Variant::StayAtZero);
        return redrawnLines(scene, [&](DrawnLine &line) {
            if (fromLeft)
                line = ascending(std::move(line));
            decide(by, line, staysAtZero);
        });
    };
    const QString end = fromLeft
        ? QStringLiteral("; steps begin at the end with the lesser x, of steep lines y.")
        : QStringLiteral("; steps begin at a line's first end.");
    return {(fromLeft ? QStringLiteral("sorted-") : QString()) + QString::fromLatin1(row.id),
            QString::fromUtf8(row.forStudent),
            QString::fromUtf8(row.forAssistant) + end,
            {},
            redraw,
            {},
            false,
            QStringLiteral("lines")};
}

} // namespace

std::vector<Defect> lineDecisionDefects()
{
    std::vector<Defect> defects;
    for (const DecisionRow &row : decisionRows()) {
        defects.push_back(defectBy(row, LineStart::AtFirstEnd));
        defects.push_back(defectBy(row, LineStart::AtLeftEnd));
    }
    return defects;
}

} // namespace pixelplumb
