// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/spandefect.h"

#include "core/grade/spanredrawings.h"
#include "core/runs/sceneplan.h"

namespace pixelplumb {

namespace {

constexpr std::size_t mostRedrawn = 64; // triangles: each is drawn by itself

struct SpanDefect {
    const char *id;
    const char *forStudent;
    const char *forAssistant; ///< %1 is a column, %2 a sample of it; or a row
    Redrawing redrawing;
};

constexpr const char *endsQuestion
    = "From which to which sample does a span go? What if its bound lies "
      "between two?";
constexpr const char *stepsQuestion = "What does a division of two whole numbers give you?";
constexpr const char *halvesQuestion = "What happens where one edge ends and the next begins?";
constexpr const char *swappedQuestion = "Which of the two edges comes first? Always?";
constexpr const char *boxQuestion
    = "Which samples of the bounding box are tested, and which are inside?";

const std::vector<SpanDefect> &walkDefects()
{
    static const std::vector<SpanDefect> rows = {
        {"ends-truncated",
         endsQuestion,
         "Both bounds of a %1 are cast to whole numbers: ⌊ ⌋ of both.",
         {truncateEnds}},
        {"ends-truncated-wrapping",
         endsQuestion,
         "Both bounds of a %1 are cast to whole numbers, and levels beyond 0 … 255, which come "
         "from that, wrap.",
         {truncateEnds, LevelOverflow::Wraps}},
        {"ends-nearest",
         endsQuestion,
         "Both bounds of a %1 are rounded to the nearest.",
         {roundToNearest}},
        {"ends-outward",
         endsQuestion,
         "A %1 goes from ⌊ ⌋ of its lower bound to ⌈ ⌉ of its upper one.",
         {roundOutward}},
        {"ends-upward",
         endsQuestion,
         "A %1 goes from ⌈ ⌉ of its lower bound to ⌈ ⌉ of its upper one.",
         {roundUpward}},
        {"last-sample-missing",
         endsQuestion,
         "Each %1's last %2 is left out: < in place of ≤.",
         {omitLastSamples}},
        {"first-sample-missing",
         endsQuestion,
         "Each %1's first %2 is left out.",
         {omitFirstSamples}},
        {"last-span-missing",
         endsQuestion,
         "The triangle's last %1 is left out: < in place of ≤.",
         {omitLastSpan}},
        {"first-span-missing",
         endsQuestion,
         "The triangle's first %1 is left out.",
         {omitFirstSpan}},
        {"middle-span-missing",
         halvesQuestion,
         "The %1 of the middle vertex is in neither half.",
         {omitMiddleSpan}},
        {"first-half-missing",
         halvesQuestion,
         "The half before the middle vertex is not drawn.",
         {omitFirstHalf}},
        {"second-half-missing",
         halvesQuestion,
         "The half behind the middle vertex is not drawn.",
         {omitSecondHalf}},
        {"middle-above-lost",
         swappedQuestion,
         "The long edge is always taken for the upper bound of a %1: triangles whose middle "
         "vertex lies beyond it are not drawn.",
         {omitWithMiddleAbove}},
        {"middle-below-lost",
         swappedQuestion,
         "The long edge is always taken for the lower bound of a %1: triangles whose middle "
         "vertex lies before it are not drawn.",
         {omitWithMiddleBelow}},
        {"whole-colour-steps",
         stepsQuestion,
         "The step of colour along a %1 is a whole number.",
         {castIncrements}},
        {"colour-divisor-plus-one",
         "By what is a difference of colours divided to have a step of colour?",
         "The step of colour along a %1 is divided by its length and one, not by its length.",
         {divideByHeightAndOne}},
        {"colours-without-edge-pre-step",
         "Which colour has an edge where it meets its first %1? Not its vertex' own.",
         "The colours of an edge begin with its vertex' own at its first %1; its ends have their "
         "pre-step.",
         {omitColourEdgePreStep}},
        {"whole-slopes", stepsQuestion, "The slopes of the edges are whole numbers.", {castSlopes}},
    };
    return rows;
}

const std::vector<SpanDefect> &boxDefects()
{
    static const std::vector<SpanDefect> rows = {
        {"box-filled",
         boxQuestion,
         "The whole bounding box is drawn: no sample is tested.",
         {fillBox}},
        {"box-filled-wrapping",
         boxQuestion,
         "The whole bounding box is drawn, and levels beyond 0 … 255 wrap.",
         {fillBox, LevelOverflow::Wraps}},
        {"box-last-row-missing",
         boxQuestion,
         "The box' last row is left out: < in place of ≤.",
         {omitLastOfBox}},
        {"box-last-column-missing",
         boxQuestion,
         "The box' last column is left out: < in place of ≤.",
         {omitEndOfBox}},
    };
    return rows;
}

Defect defectOf(const SpanDefect &row, TriangleWay way)
{
    const QString span
        = way == TriangleWay::Columns ? QStringLiteral("column") : QStringLiteral("row");
    QString forAssistant = QString::fromUtf8(row.forAssistant);
    forAssistant.replace(QStringLiteral("%1"), span)
        .replace(QStringLiteral("%2"), QStringLiteral("sample"));
    return {QString::fromLatin1(row.id),
            QString::fromUtf8(row.forStudent).replace(QStringLiteral("%1"), span),
            forAssistant,
            {},
            [redrawing = row.redrawing](const Picture &, const Scene &scene) {
                return redrawn(scene, redrawing);
            },
            false,
            QStringLiteral("spans")};
}

} // namespace

std::vector<Defect> spanDefectsFor(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    const bool canBeRedrawn = method.draws(PrimitiveKind::Triangle) && scene.shapes.empty()
        && !scene.triangles.empty() && scene.triangles.size() <= mostRedrawn
        && !mayCallForEffects(scene);
    if (!canBeRedrawn)
        return {};
    const TriangleWay way = triangleWayOf(method);
    std::vector<Defect> defects;
    for (const SpanDefect &row : way == TriangleWay::Box ? boxDefects() : walkDefects())
        defects.push_back(defectOf(row, way));
    const auto unchanged = [](TriangleRuns &) {};
    defects.push_back(
        defectOf({"parity",
                  "What happens to a pixel that two triangles paint?",
                  "Pixels are toggled, not painted: what two triangles paint is background again.",
                  {unchanged, LevelOverflow::Clamps, Repainting::Toggles}},
                 way));
    return defects;
}

} // namespace pixelplumb
