// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygonkernels.h"
#include "core/methods/polygons.h"

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
        = QStringLiteral("a sample on the boundary of a polygon is in or out by the parity of "
                         "crossings, which is certain only for a sample displaced to the right "
                         "and a little downward");
    return method;
}

Pseudocode parityPseudocode()
{
    return {{0,
             QStringLiteral("edge table ← all edges that are not horizontal, by their first row"),
             {Moment::SetUp}},
            {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
            {0, QStringLiteral("for each row y that edges cross:"), {Moment::Begin, Moment::Span}},
            {1,
             QStringLiteral("active edges ← those that begin here, without those that have ended"),
             {Moment::Begin, Moment::Span}},
            {1,
             QStringLiteral(
                 "x of each ← from its end of smaller y where it begins, else x + m; sort by x"),
             {Moment::Begin, Moment::Span}},
            {1,
             QStringLiteral("for each sample from the first crossing to the last:"),
             {Moment::First, Moment::Next, Moment::Refused}},
            {2,
             QStringLiteral("c ← the crossings at or to the left of it; p ← c mod 2, w ← downward "
                            "minus upward ones"),
             {Moment::First, Moment::Next, Moment::Refused}},
            {2,
             QStringLiteral("if p = 1 by even-odd, or w ≠ 0 by non-zero: pixel (x, y) ← colour"),
             {Moment::First, Moment::Next}}};
}

Method polygonParityMethod()
{
    Method method = polygonMethod(methodOf<ParityKernel>());
    method.id = QStringLiteral("polygon-parity");
    method.title = QStringLiteral("Polygon by parity");
    method.source = QStringLiteral("Scan Conversion slides, “Scan Conversion: A General "
                                   "Algorithm”");
    method.pseudocode = parityPseudocode();
    method.summary = QStringLiteral("Intersects each row with the active edges, sorts the "
                                    "crossings in x, and fills by their parity or winding number.");
    method.remarks
        = {QStringLiteral("concave"), QStringLiteral("self-crossing"), QStringLiteral("holes"),
           QStringLiteral("even-odd"), QStringLiteral("non-zero")};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
