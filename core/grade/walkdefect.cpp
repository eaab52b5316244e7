// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/walkdefect.h"

#include "core/grade/programwalk.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

struct WalkDefect {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    ProgramWalk walk;
    LevelOverflow overflow = LevelOverflow::Clamps;
};

constexpr const char *endsQuestion
    = "From which to which sample does a span go? What if its bound lies "
      "between two?";
constexpr const char *stepsQuestion = "What does a division of two whole numbers give you?";

const std::vector<WalkDefect> &spanRows()
{
    constexpr auto down = EndRounding::Down;
    constexpr auto up = EndRounding::Up;
    static const std::vector<WalkDefect> rows = {
        {"ends-truncated",
         endsQuestion,
         "Both bounds of a %1 are cast to whole numbers: ⌊ ⌋ of both.",
         {.first = down, .last = down}},
        {"ends-truncated-wrapping",
         endsQuestion,
         "Both bounds of a %1 are cast to whole numbers, and levels beyond 0 … 255, which come "
         "from that, wrap.",
         {.first = down, .last = down},
         LevelOverflow::Wraps},
        {"ends-nearest",
         endsQuestion,
         "Both bounds of a %1 are rounded to the nearest.",
         {.first = EndRounding::Nearest, .last = EndRounding::Nearest}},
        {"ends-outward",
         endsQuestion,
         "A %1 goes from ⌊ ⌋ of its lower bound to ⌈ ⌉ of its upper one.",
         {.first = down, .last = up}},
        {"ends-upward",
         endsQuestion,
         "A %1 goes from ⌈ ⌉ of its lower bound to ⌈ ⌉ of its upper one.",
         {.first = up, .last = up}},
        {"whole-colour-steps",
         stepsQuestion,
         "The step of colour along a %1 is a whole number; its first sample is right.",
         {.steps = Quotient::Whole}},
        {"whole-colour-rates",
         stepsQuestion,
         "The step of colour along a %1 is a whole number, in the pre-step to its first sample, "
         "too.",
         {.preSteps = Quotient::Whole, .steps = Quotient::Whole}},
        {"colour-divisor-plus-one",
         "By what is a difference of colours divided to have a step of colour?",
         "The step of colour along a %1 is divided by its length and one, not by its length.",
         {.divisor = SpanDivisor::HeightAndOne}},
        {"colours-between-samples",
         "Which colour has a bound that lies between two samples, and which the sample beside it?",
         "The first and the last sample of a %1 have the colours of its bounds: the step of colour "
         "is divided by the steps from the one to the other.",
         {.divisor = SpanDivisor::WholeSteps}},
    };
    return rows;
}

const std::vector<WalkDefect> &edgeRows()
{
    constexpr auto whole = Quotient::Whole;
    static const std::vector<WalkDefect> rows = {
        {"colours-without-edge-pre-step",
         "Which colour has an edge where it meets its first %1? Not its vertex' own.",
         "The colours of an edge begin with its vertex' own at its first %1; its ends have their "
         "pre-step.",
         {.edgeColourStart = EdgeColourStart::OfVertex}},
        {"whole-slopes",
         stepsQuestion,
         "The slopes of the edges are whole numbers; colours along them are right, and those of a "
         "%1 go from one of its wrong ends to the other.",
         {.slopes = whole}},
        {"whole-edge-colours",
         stepsQuestion,
         "The steps of colour along the edges are whole numbers; their slopes are not.",
         {.edgeColours = whole}},
        {"whole-edge-steps",
         stepsQuestion,
         "The slopes of the edges and the steps of colour along them are whole numbers; the step "
         "of colour along a %1 is not.",
         {.slopes = whole, .edgeColours = whole}},
        {"whole-colours",
         stepsQuestion,
         "All steps of colour are whole numbers, along edges and along a %1; slopes are not.",
         {.edgeColours = whole, .preSteps = whole, .steps = whole}},
        {"whole-increments",
         stepsQuestion,
         "All increments are whole numbers: slopes and steps of colour, along edges and along a "
         "%1.",
         {.slopes = whole, .edgeColours = whole, .preSteps = whole, .steps = whole}},
    };
    return rows;
}

QString fromBelow(const QString &id) { return id + QStringLiteral("-from-below"); }

QString orderSentence(WalkOrder order)
{
    return order == WalkOrder::Descending
        ? QStringLiteral(" The rows are gone through from the greatest y down.")
        : QStringLiteral(" The rows are gone through from the least y up.");
}

QString variantSentence(Variant variant, SpanAxis axis)
{
    const VariantWords &words = wordsOf(variant, axis);
    return QStringLiteral("%1: %2 in place of %3.")
        .arg(nameText(words.title), nameText(words.printed), nameText(words.right));
}

/// From below an edge has another way to its first row than the words of the method tell.
QString upwardSentence(Variant variant)
{
    if (variant != Variant::NoEdgePreStep)
        return variantSentence(variant, SpanAxis::Row);
    return QStringLiteral("%1: x = x₀ at the first row in place of x = x₀ + (⌈y₀⌉ − y₀)·m.")
        .arg(nameText(wordsOf(variant, SpanAxis::Row).title));
}

} // namespace

QString sentenceOf(Variant variant, SpanAxis axis)
{
    const bool hasOrder = axis == SpanAxis::Row
        && std::ranges::find(variantsAlongEdges, variant) != variantsAlongEdges.end();
    return variantSentence(variant, axis)
        + (hasOrder ? orderSentence(WalkOrder::Descending) : QString());
}

Defect redrawnDefect(const QString &id, const QString &forStudent, const QString &forAssistant,
                     const Redrawing &redrawing, SpanAxis axis)
{
    const auto filledIn = [axis](QString text) {
        const bool goesByColumns = axis == SpanAxis::Column;
        return text
            .replace(QStringLiteral("%1"),
                     goesByColumns ? QStringLiteral("column") : QStringLiteral("row"))
            .replace(QStringLiteral("%2"),
                     goesByColumns ? QStringLiteral("x") : QStringLiteral("y"));
    };
    return {id,
            filledIn(forStudent),
            filledIn(forAssistant),
            {},
            [redrawing](const Scene &scene) { return redrawn(scene, redrawing); },
            {},
            false,
            QStringLiteral("spans")};
}

std::vector<Defect> walkDefectsFor(SpanAxis axis)
{
    if (axis == SpanAxis::Free)
        return {};
    std::vector<Defect> defects;
    const auto add = [&](const QString &id, const QString &forStudent, const QString &forAssistant,
                         const ProgramWalk &walk, LevelOverflow overflow) {
        defects.push_back(
            redrawnDefect(id, forStudent, forAssistant, {walking(walk), overflow}, axis));
    };
    for (const WalkDefect &row : spanRows())
        add(QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
            QString::fromUtf8(row.forAssistant), row.walk, row.overflow);
    const auto addUpward = [&](const QString &id, const QString &forStudent,
                               const QString &forAssistant, ProgramWalk walk) {
        walk.order = WalkOrder::Ascending;
        add(fromBelow(id), forStudent, forAssistant + orderSentence(WalkOrder::Ascending), walk,
            LevelOverflow::Clamps);
    };
    const bool hasOrder = axis == SpanAxis::Row;
    for (const WalkDefect &row : edgeRows()) {
        const QString id = QString::fromLatin1(row.id);
        const QString forStudent = QString::fromUtf8(row.forStudent);
        const QString forAssistant = QString::fromUtf8(row.forAssistant);
        add(id, forStudent,
            forAssistant + (hasOrder ? orderSentence(WalkOrder::Descending) : QString()), row.walk,
            row.overflow);
        if (hasOrder)
            addUpward(id, forStudent, forAssistant, row.walk);
    }
    for (const Variant variant : variantsAlongEdges) {
        if (hasOrder)
            addUpward(nameText(nameOf(variant)), nameText(wordsOf(variant, axis).fault),
                      upwardSentence(variant), {.departures = VariantSet().with(variant)});
    }
    return defects;
}

} // namespace pixelplumb
