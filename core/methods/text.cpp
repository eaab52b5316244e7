// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/text.h"

#include "core/methods/polygonkernels.h"
#include "core/methods/polygons.h"

namespace pixelplumb {

Method textOutlinesMethod()
{
    Method method = polygonMethod(methodOf<TextKernel>());
    method.id = QStringLiteral("text-outlines");
    method.title = QStringLiteral("Text as outlines");
    method.family = MethodFamily::Others;
    method.source = QStringLiteral("Rasterization slides, “Output Primitives” (characters); "
                                   "Scan Conversion slides, “Scan Conversion: A General "
                                   "Algorithm”");
    method.pseudocode = {
        {0, QStringLiteral("contours ← the outlines of the glyphs in the font"), {Moment::SetUp}},
        {0,
         QStringLiteral("edge table ← all edges that are not horizontal, by their first row"),
         {Moment::SetUp}},
        {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
        {0, QStringLiteral("for each row y that edges cross:"), {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("active edges ← those that begin here, without those that have ended"),
         {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("x of each ← from its lower end where it begins, else x + m; sort by x"),
         {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("for each sample from the first crossing to the last:"),
         {Moment::First, Moment::Next, Moment::Refused}},
        {2,
         QStringLiteral("c ← the crossings at or to the left of it; p ← c mod 2, w ← upward minus "
                        "downward ones"),
         {Moment::First, Moment::Next, Moment::Refused}},
        {2,
         QStringLiteral("if p = 1 by even-odd, or w ≠ 0 by non-zero: pixel (x, y) ← colour"),
         {Moment::First, Moment::Next}}};
    method.summary = QStringLiteral("Takes the outlines of the glyphs from a font and fills them "
                                    "as one polygon by winding number.");
    method.remarks = {QStringLiteral("text"), QStringLiteral("non-zero")};
    method.kinds = {PrimitiveKind::Text};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
