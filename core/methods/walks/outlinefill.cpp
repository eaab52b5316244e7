// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/outlinefill.h"

namespace pixelplumb {

Method outlineFillMethod()
{
    Method method = methodOf<OutlineFillKernel>();
    method.id = QStringLiteral("midpoint-outline-fill");
    method.title = QStringLiteral(QT_TRANSLATE_NOOP("core", "Midpoint outline, filled"));
    method.source = QStringLiteral("Triangles slides, “Use Midpoint Algorithm for edges and fill "
                                   "in?”; Rasterization slides, “Bresenham's Line Algorithm”");
    method.pseudocode = {
        {0, QStringLiteral("round P₀, P₁ and P₂ to whole pixels"), {Moment::SetUp}},
        {0,
         QStringLiteral("the outline ← the pixels of P₀P₁, P₁P₂ and P₂P₀ by the midpoint "
                        "algorithm"),
         {Moment::SetUp}},
        {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
        {0, QStringLiteral("for each column x of the outline:"), {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("y_low, y_high ← its smallest and its largest y there"),
         {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("R_low, R_high ← R along their edges; if y_low < y_high: ΔR ← (R_high − "
                        "R_low)/(y_high − y_low); G and B likewise"),
         {Moment::Begin, Moment::Span}},
        {1, QStringLiteral("for each row y from y_low to y_high:"), {Moment::First, Moment::Next}},
        {2, QStringLiteral("the first: R ← R_low; G and B likewise"), {Moment::First}},
        {2, QStringLiteral("else: R ← R + ΔR; G and B likewise"), {Moment::Next}},
        {2, QStringLiteral("pixel (x, y) ← the bytes of R, G, B"), {Moment::First, Moment::Next}}};
    method.summary = QStringLiteral(
        QT_TRANSLATE_NOOP("core",
                          "Draws the three edges as lines of whole pixels and fills each "
                          "column from the smallest to the largest y of them: pixels "
                          "nearest to an edge are painted on whichever side of it they "
                          "lie, those of a shared edge twice."));
    method.remarks += QStringLiteral("whole-pixel vertices");
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("the pixels of the outline are painted whatever side of "
                                           "the edge they lie on");
    return method;
}

} // namespace pixelplumb
