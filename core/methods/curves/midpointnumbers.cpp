// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/curvenumbers.h"
#include "core/methods/words/placenumbers.h"

/// The numbers of circles and ellipses by the midpoint algorithm.
namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// A decision parameter of the midpoint circle.
Quantity decisionIn(const MidpointStep &step, Int128 number)
{
    return Quantity::rational(number, step.decisionUnit);
}

/// % stands for the radius along the arc, # for the one across it.
QString ofArc(QString formula, const MidpointStep &step)
{
    const bool isFlat = step.arc == 0;
    return formula.replace(u'%', isFlat ? u"r_x"_s : u"r_y"_s)
        .replace(u'#', isFlat ? u"r_y"_s : u"r_x"_s);
}

/// Of a step whose predecessor is not shown, from its own place.
void specifyMidpoint(NumberDescription &description, const MidpointStep &step)
{
    if (!step.isEntry || !step.hasDecision)
        return;
    const QString row = step.down == 0 ? u"(y_k − ½)²"_s
        : step.down == 1               ? u"(y_k + ½)²"_s
                                       : u"(y_k + %1 + ½)²"_s.arg(step.down - 1);
    description.formula = step.isScaled()
        ? u"p_k = x_k² + "_s + row + u" − r_x²"_s
        : ofArc(u"p_k = #²·x_k² + %²·"_s + row + u" − %²·#²"_s, step);
}

void specifyNextMidpoint(NumberDescription &description, const MidpointStep &step)
{
    if (step.hasDecision)
        return;
    if (step.arc == 0 && step.x == 0)
        description.formula = "p_k₊₁ = p₀";
    else if (step.isScaled())
        description.formula = "p_k₊₁ = (x_k + 1)² + (y_k − ½)² − r_x²";
    else
        description.formula = ofArc("p_k₊₁ = #²·(x_k + 1)² + %²·(y_k − ½)² − %²·#²", step);
}

/// Follows the branch that was taken: the row stays, goes one down or, where the arc is steep,
/// several.
void specifyMidpointIncrement(NumberDescription &description, const MidpointStep &step)
{
    const QString along = step.isScaled() ? u"2·x_k + 1"_s : u"#²·(2·x_k + 1)"_s;
    const QString scale = step.isScaled() ? QString() : u"%²·"_s;
    QString across = step.down == 0 ? QString()
        : step.down == 1            ? u" − 2·"_s + scale + u"y_k"_s
                         : u" − "_s + scale + u"(y_k′·(y_k′ − 1) − y_k·(y_k − 1))"_s;
    if (step.isEntry && step.down > 1)
        across = u" − "_s + scale + u"%1·(2·y_k + %2)"_s.arg(step.down).arg(step.down - 1);
    description.formula = ofArc(u"Δp = "_s + along + across, step);
}

} // namespace

const NumberTable<MidpointSetUp> &midpointSetUpNumbers()
{
    static const auto numbers = [] {
        const auto toolTip = [](const QString &function) {
            return u"F(x, y) = %1 at the first midpoint, (1, r_y − ½) from the centre."_s.arg(
                function);
        };
        const QString ofEqualRadii = "x² + y² − r_x²";
        const QString ofOthers = "r_y²·x² + r_x²·y² − r_x²·r_y²";
        NumberTable<MidpointSetUp> table;
        for (const NumberRow<Round> &row : roundSetUpNumbers())
            table.push_back(
                {row.description, [read = row.read](const MidpointSetUp &setUp) {
                     return read({{setUp.centre.x * unitsPerPixel, setUp.centre.y * unitsPerPixel},
                                  setUp.radiusX * unitsPerPixel,
                                  setUp.radiusY * unitsPerPixel});
                 }});
        table.push_back(
            {plainNumber("p_0", "p₀", {},
                         toolTip(ofOthers + u", of equal radii "_s + ofEqualRadii + u','),
                         "p₀ = r_y² − r_x²·r_y + r_x²/4", Group::Decision),
             [](const MidpointSetUp &setUp) {
                 const MidpointStep first = midpointStepAt(setUp.arc(0), 0, 0);
                 return isOnePixel(first) ? Quantity() : decisionIn(first, first.nextDecision);
             },
             [=](NumberDescription &description, const MidpointSetUp &setUp) {
                 const bool hasEqualRadii = setUp.isCircle() && setUp.radiusX != 0;
                 description.toolTip = toolTip(hasEqualRadii ? ofEqualRadii : ofOthers);
                 if (hasEqualRadii)
                     description.formula = "p₀ = 5/4 − r_x";
             }});
        return table;
    }();
    return numbers;
}

const NumberTable<MidpointStep> &circleMidpointNumbers()
{
    const NumberDescription decision
        = plainNumber("p_k", "p_k", {},
                      "F at x_k, midway between the y_k of the step before and the one inwards: "
                      "positive outside, so that the inner one is nearer.",
                      "p_k ← p_k₊₁′", Group::Decision);
    const NumberDescription next = plainNumber(
        "p_next", "p_k₊₁", {}, "F at x_k + 1, midway between this y_k and the one inwards.",
        "p_k₊₁ = p_k + Δp", Group::Decision);
    static const NumberTable<MidpointStep> numbers = {
        {plainNumber("arc", "arc", {},
                     "1: x_k along x, of equal radii mirrored into all octants; 2: x_k along y."),
         [](const MidpointStep &step) { return Quantity::integer(step.arc + 1); }},
        {decision,
         [](const MidpointStep &step) {
             return step.hasDecision ? decisionIn(step, step.decision) : Quantity();
         },
         specifyMidpoint},
        {plainNumber("x_k", "x_k", "px", "From the centre along the arc."),
         [](const MidpointStep &step) { return Quantity::integer(step.x); }},
        {plainNumber("y_k", "y_k", "px", "From the centre across the arc.", {}, Group::Span),
         [](const MidpointStep &step) { return Quantity::integer(step.y); }},
        {plainNumber("increment", "Δp", {},
                     "2x_k + 1 where y_k stays, less 2y_k where it goes one inwards; of unequal "
                     "radii times their squares.",
                     {}, Group::Span),
         [](const MidpointStep &step) {
             return step.hasDecision ? decisionIn(step, step.nextDecision - step.decision)
                                     : Quantity();
         },
         specifyMidpointIncrement},
        {next,
         [](const MidpointStep &step) {
             return isOnePixel(step) ? Quantity() : decisionIn(step, step.nextDecision);
         },
         specifyNextMidpoint}};
    return numbers;
}

} // namespace pixelplumb
