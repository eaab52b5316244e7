// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/walkdefect.h"

#include "core/grade/programwalk.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

namespace {

struct WalkDefect {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    ProgramWalk walk;
    LevelOverflow overflow = LevelOverflow::Clamps;
};

struct NamedWalk {
    QString id, forStudent, forAssistant;
    ProgramWalk walk;
    LevelOverflow overflow = LevelOverflow::Clamps;
};

constexpr const char *endsQuestion
    = "From which to which sample does a span go? What if its bound lies "
      "between two?";
constexpr const char *stepsQuestion = "What does a division of two whole numbers give you?";
constexpr const char *storedQuestion = "What type has a colour while it is stepped?";

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
         {.steps = Kept::TowardZero}},
        {"whole-colour-rates",
         stepsQuestion,
         "The step of colour along a %1 is a whole number, in the pre-step to its first sample, "
         "too.",
         {.preSteps = Kept::TowardZero, .steps = Kept::TowardZero}},
        {"whole-span-levels",
         storedQuestion,
         "The colour along a %1 is kept as a whole number: at each sample its fraction is lost.",
         {.levels = Kept::TowardZero}},
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
    constexpr auto whole = Kept::TowardZero;
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
        {"whole-levels",
         storedQuestion,
         "Colours are kept as whole numbers, along edges and along a %1: at each step their "
         "fraction is lost.",
         {.edgeLevels = whole, .levels = whole}},
        {"no-pre-step-behind-middle",
         "Where does the second of the two short edges begin? And which colour has it there?",
         "The edge from the middle vertex to the last has no pre-step: at its first %1 it has the "
         "vertex' own place and colour. The others have theirs.",
         {.departuresBehindMiddle = VariantSet().with(Variant::NoEdgePreStep)}},
        {"loops-truncated",
         "At which %1 do your loops begin and end, and where is the edge there?",
         "Loops go from (int)%2 of a vertex to (int)%2 of the next; an edge has its vertex' own "
         "place and colour at the first %1.",
         {.spans = EndRounding::Down}},
    };
    return rows;
}

/// The same with whole numbers as Python's // gives them; none where nothing is divided so.
std::optional<ProgramWalk> dividedDown(ProgramWalk walk)
{
    bool isDivided = false;
    for (Kept *kept : {&walk.slopes, &walk.edgeColours, &walk.preSteps, &walk.steps}) {
        if (*kept == Kept::All)
            continue;
        *kept = Kept::Down;
        isDivided = true;
    }
    return isDivided ? std::optional(walk) : std::nullopt;
}

/// The rows, and behind each that divides as C does the one that does as Python.
std::vector<NamedWalk> namedWalks(const std::vector<WalkDefect> &rows)
{
    std::vector<NamedWalk> walks;
    for (const WalkDefect &row : rows) {
        NamedWalk walk{QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
                       QString::fromUtf8(row.forAssistant), row.walk, row.overflow};
        const auto down = dividedDown(row.walk);
        if (!down) {
            walks.push_back(walk);
            continue;
        }
        NamedWalk ofPython = walk;
        ofPython.id.replace(QStringLiteral("whole-"), QStringLiteral("floor-"));
        ofPython.walk = *down;
        ofPython.forAssistant
            += QStringLiteral(" A quotient is rounded down, as by // in Python, not toward 0.");
        walk.forAssistant += QStringLiteral(" A quotient is cut toward 0, as by / in C.");
        walks.push_back(walk);
        walks.push_back(ofPython);
    }
    return walks;
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
    const QString sentence
        = QStringLiteral("%1: %2 in place of %3.")
              .arg(nameText(words.title), nameText(words.printed), nameText(words.right));
    if (variant != Variant::DivisorMinusOne)
        return sentence;
    return sentence
        + QStringLiteral(" Where that leaves nothing to divide by, an edge keeps its "
                         "vertex' place and colour.");
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
    return redrawnBy(redrawing, {id, filledIn(forStudent), filledIn(forAssistant)});
}

std::vector<Defect> walkDefectsFor(SpanAxis axis)
{
    if (axis == SpanAxis::Free)
        return {};
    std::vector<Defect> defects;
    const auto add = [&](const NamedWalk &named) {
        defects.push_back(redrawnDefect(named.id, named.forStudent, named.forAssistant,
                                        redrawingBy(named.walk, named.overflow), axis));
    };
    std::ranges::for_each(namedWalks(spanRows()), add);
    const auto addUpward = [&](NamedWalk named) {
        named.id = fromBelow(named.id);
        named.forAssistant += orderSentence(WalkOrder::Ascending);
        named.walk.order = WalkOrder::Ascending;
        add(named);
    };
    const bool hasOrder = axis == SpanAxis::Row;
    for (const NamedWalk &named : namedWalks(edgeRows())) {
        NamedWalk ofMethod = named;
        if (hasOrder)
            ofMethod.forAssistant += orderSentence(WalkOrder::Descending);
        add(ofMethod);
        if (hasOrder)
            addUpward(named);
    }
    for (const Variant variant : variantsAlongEdges) {
        if (hasOrder)
            addUpward({nameText(nameOf(variant)),
                       nameText(wordsOf(variant, axis).fault),
                       upwardSentence(variant),
                       {.departures = VariantSet().with(variant)}});
    }
    return defects;
}

} // namespace pixelplumb
