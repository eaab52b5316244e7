// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

Method polygonMethod(Method method)
{
    method.family = MethodFamily::Polygons;
    method.kinds = {PrimitiveKind::Polygon};
    method.fills = {ShapeFill::EvenOdd, ShapeFill::NonZero};
    method.effects = {Effect::Clipping};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::TopLeft};
    method.fillRuleReason
        = "a sample on the boundary of a polygon is in or out by the parity of crossings, which is "
          "certain only for a sample displaced to the right and a little downward";
    return method;
}

namespace {

using enum Moment;

/// What a line says in a frame whose y points down, where down on the screen is towards larger y.
std::vector<RuledLine> yDown(const QString &text)
{
    return {{FillRule::TopLeft, text, FrameOrigin::TopLeft}};
}

} // namespace

Pseudocode crossingLines(int depth)
{
    const auto active = [](const QString &condition) {
        return u"for each edge k from (x₀, y₀) to (x₁, y₁) with %1: — the active edges"_s.arg(
            condition);
    };
    return {
        {depth, "for each row y of the frame from y_first to y_last:", {Begin, Span}},
        {depth + 1,
         active("y₀ < y ≤ y₁, or y₁ < y ≤ y₀"),
         {Begin, Span},
         {},
         {},
         yDown(active("y₀ ≤ y < y₁, or y₁ ≤ y < y₀"))},
        {depth + 2,
         "where it begins: x_k ← x₀ + (y − y₀)·((x₁ − x₀)/(y₁ − y₀)) if y₀ < y₁, else x₁ + (y − "
         "y₁)·((x₁ − x₀)/(y₁ − y₀)) — from its end of smaller y",
         {Begin, Span}},
        {depth + 2, "else: x_k ← x_k + (x₁ − x₀)/(y₁ − y₀)", {Begin, Span}}};
}

Pseudocode parityPseudocode()
{
    const std::vector<Moment> samples = {First, Next, Refused};
    const auto counted = [](QChar sign) {
        return u"for each edge k of them with x_k ≤ x: c, w ← c + 1, w + 1 if y₁ %1 y₀, else c "
               "+ 1, w − 1 — w, the winding number, is 1 more where it runs downward"_s.arg(sign);
    };
    Pseudocode code = {{0, "given: the edges of the contours that are not horizontal", {SetUp}},
                       {0, "if no sample is to be drawn: done", {Rejected}}};
    std::ranges::move(crossingLines(0), std::back_inserter(code));
    code.push_back(
        {1,
         "for each x from ⌈min x_k⌉ to ⌈max x_k⌉ − 1: — the kernel passes the x_k in sorted order",
         samples});
    code.push_back({2, "c, w ← 0, 0", samples});
    code.push_back({2, counted(u'<'), samples, {}, {}, yDown(counted(u'>'))});
    code.push_back({2,
                    "if c mod 2 = 1 by even-odd, or w ≠ 0 by non-zero: pixel (x, y) ← colour",
                    {First, Next}});
    return code;
}

Method polygonParityMethod()
{
    Method method = polygonMethod(methodOf<ParityKernel>());
    method.id = "polygon-parity";
    method.title = QT_TRANSLATE_NOOP("core", "Polygon by parity");
    method.source = "Scan Conversion slides, “Scan Conversion: A General Algorithm”";
    method.pseudocode = parityPseudocode();
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Intersects each row with the active edges, sorts the crossings in x, "
                            "and fills by their parity or winding number.");
    method.remarks = {"concave", "self-crossing", "holes", "even-odd", "non-zero"};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
