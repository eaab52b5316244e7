// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkdefect.h"

#include "core/grade/bugs/walkrows.h"
#include "core/grade/scan/programwalk.h"
#include "core/scan/choicenames.h"
#include "core/scan/mistakes/variededge.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace pixelplumb {

namespace {

struct NamedWalk {
    QString id, forStudent, forAssistant;
    ScanBugs bugs;
};

/// The bugs with whole numbers as by Python's //; none where they have no such division.
std::optional<ScanBugs> dividedDown(ScanBugs bugs)
{
    bool isDivided = false;
    const auto divide = [&isDivided](std::initializer_list<Truncation *> quotients) {
        for (Truncation *kept : quotients) {
            if (*kept != Truncation::TowardZero)
                continue;
            *kept = Truncation::Down;
            isDivided = true;
        }
    };
    divide({&bugs.slopes, &bugs.edgeColours, &bugs.preSteps, &bugs.steps});
    if (isOfAdded(bugs.edgeStoring))
        divide({&bugs.edgePlaces, &bugs.edgeLevels});
    if (isOfAdded(bugs.spanStoring))
        divide({&bugs.levels});
    return isDivided ? std::optional(bugs) : std::nullopt;
}

/// A row, or where it divides as C does, also its version that divides as Python does.
std::vector<NamedWalk> namedWalks(const WalkRow &row)
{
    NamedWalk named{QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
                    QString::fromUtf8(row.forAssistant), row.bugs};
    const auto down = dividedDown(row.bugs);
    if (!down)
        return {named};
    NamedWalk ofPython = named;
    ofPython.id.replace(u"whole-"_s, u"floor-"_s);
    ofPython.bugs = *down;
    ofPython.forAssistant += u" A quotient is rounded down, as by // in Python, not toward 0."_s;
    named.forAssistant += u" A quotient is cut toward 0, as by / in C."_s;
    return {named, ofPython};
}

QString orderSentence(SpanOrder order)
{
    return order == SpanOrder::Descending
        ? u" The rows are gone through from the greatest y down."_s
        : u" The rows are gone through from the least y up."_s;
}

/// Fills in the distances from a vertex to the spans after and before it.
NamedWalk withWays(NamedWalk named, SpanOrder order)
{
    const bool isUpward = order == SpanOrder::Ascending;
    const auto up = u"⌈%2₀⌉ − %2₀"_s;
    const auto down = u"%2₀ − ⌊%2₀⌋"_s;
    named.forAssistant.replace(u"%5"_s, isUpward ? up : down)
        .replace(u"%6"_s, isUpward ? down : up);
    return named;
}

/// Vertices' colours are whole: rounded down, what is added to them makes the same from either end.
bool isSameFromBelow(const ScanBugs &bugs)
{
    ScanBugs others = bugs;
    others.edgeLevels = others.levels = Truncation::All;
    others.edgeStoring = others.spanStoring = Storing::FromFirst;
    return isOfAdded(bugs.edgeStoring) && bugs.edgeLevels == Truncation::Down && others.isRight();
}

NamedWalk fromBelow(NamedWalk named)
{
    named.id += u"-from-below"_s;
    named.forAssistant += orderSentence(SpanOrder::Ascending);
    named.bugs.order = WalkOrder::Ascending;
    return named;
}

QString variantSentence(Variant variant, SpanAxis axis)
{
    const VariantWords &words = wordsOf(variant, axis);
    const QString sentence = u"%1: %2 in place of %3."_s.arg(
        nameText(words.title), nameText(words.printed), nameText(words.right));
    if (variant != Variant::DivisorMinusOne)
        return sentence;
    return sentence
        + u" An edge of at most a pixel is not divided by what is left, 0 or less: "
          "it keeps its vertex' place and colour."_s;
}

/// From below, an edge's distance to its first row differs from the one in the method's text.
QString upwardSentence(Variant variant)
{
    if (variant != Variant::NoEdgePreStep)
        return variantSentence(variant, SpanAxis::Row);
    return u"%1: x = x₀ at the first row in place of x = x₀ + (⌈y₀⌉ − y₀)·m."_s.arg(
        nameText(wordsOf(variant, SpanAxis::Row).title));
}

} // namespace

QString sentenceOf(Variant variant, SpanAxis axis)
{
    const bool hasOrder = axis == SpanAxis::Row
        && std::ranges::find(variantsAlongEdges, variant) != variantsAlongEdges.end();
    return variantSentence(variant, axis)
        + (hasOrder ? orderSentence(SpanOrder::Descending) : QString());
}

Defect redrawnDefect(const QString &id, const QString &forStudent, const QString &forAssistant,
                     const Redrawing &redrawing, SpanAxis axis)
{
    const bool goesByColumns = axis == SpanAxis::Column;
    const auto filledIn = [goesByColumns](QString text) {
        const auto fill = [&](const char *place, const char *ofColumns, const char *ofRows) {
            text.replace(QLatin1String(place),
                         QString::fromUtf8(goesByColumns ? ofColumns : ofRows));
        };
        fill("%1", "column", "row");
        fill("%2", "x", "y");
        fill("%3", "y", "x");
        fill("%4", "y_B", "x_L");
        return text;
    };
    return redrawnBy(redrawing, {id, filledIn(forStudent), filledIn(forAssistant)});
}

std::vector<Defect> walkDefectsFor(SpanAxis axis)
{
    if (axis == SpanAxis::Free)
        return {};
    std::vector<Defect> defects;
    const bool goesByRows = axis == SpanAxis::Row;
    const auto add = [&](const NamedWalk &named) {
        defects.push_back(redrawnDefect(named.id, named.forStudent, named.forAssistant,
                                        redrawingBy(named.bugs), axis));
    };
    const auto addFromBothEnds = [&](const NamedWalk &named) {
        NamedWalk ofMethod = withWays(named, SpanOrder::Descending);
        ofMethod.forAssistant += orderSentence(SpanOrder::Descending);
        add(ofMethod);
        add(fromBelow(withWays(named, SpanOrder::Ascending)));
    };
    for (const auto &rows : {spanWalkRows(), spanColourRows(), edgeWalkRows(), numberWalkRows(),
                             edgeColourRows(), middleWalkRows(), mistakenRateRows()}) {
        for (const WalkRow &row : rows) {
            if (goesByRows && row.bugs.upperEdge == UpperEdge::LongBySlopes)
                continue; // the lesser x is the left bound, whatever the slopes
            for (const NamedWalk &named : namedWalks(row)) {
                if (goesByRows && named.bugs.hasOrder() && !isSameFromBelow(named.bugs))
                    addFromBothEnds(named);
                else
                    add(withWays(named, SpanOrder::Ascending));
            }
        }
    }
    for (const Variant variant : variantsAlongEdges) {
        const VariantSet alone = VariantSet().with(variant);
        ScanBugs bugs{.edgeChanges = edgeChangesOf(alone)};
        if (variant == Variant::UnsortedColours)
            bugs.vertexColours = VertexColours::AsGiven;
        if (goesByRows)
            add(fromBelow({nameText(nameOf(variant)), nameText(wordsOf(variant, axis).fault),
                           upwardSentence(variant), bugs}));
    }
    return defects;
}

std::vector<Defect> flatEdgeChoicesFor(SpanAxis axis)
{
    const auto choice = [axis](const char *id, const char *forStudent, const char *forAssistant,
                               const ScanBugs &bugs) {
        Defect defect
            = redrawnDefect(QString::fromLatin1(id), QString::fromUtf8(forStudent),
                            QString::fromUtf8(forAssistant) + u" That alone is no mistake."_s,
                            redrawingBy(bugs), axis);
        defect.isRightAlone = true;
        return defect;
    };
    constexpr const char *order = "Which of two vertices with one %2 comes first?";
    constexpr const char *end
        = "From where to where does the last %1 go if two vertices lie on it?";
    return {choice("equal-as-given", order,
                   "Of two vertices with one %2 the one that was given first comes first, not the "
                   "one with the least %3.",
                   {.vertices = VertexOrder::ByXThenAsGiven}),
            choice("equal-descending", order,
                   "Of two vertices with one %2 the one with the greatest %3 comes first, not the "
                   "one with the least.",
                   {.vertices = VertexOrder::ByXThenDown}),
            choice("flat-end-from-vertices", end,
                   "Where two vertices lie on the last %1, it goes from the one to the other, not "
                   "to where the long edge has come.",
                   {.flatEnd = FlatEnd::FromVertices}),
            choice("flat-end-from-edges", end,
                   "Where two vertices lie on the last %1, its bounds are what the two edges "
                   "before it have come to, and neither vertex.",
                   {.flatEnd = FlatEnd::FromEdgesBefore})};
}

} // namespace pixelplumb
