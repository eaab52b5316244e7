// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygonkernels.h"
#include "core/methods/polygons.h"

namespace pixelplumb {

Method polygonMethod(Method method)
{
    method.family = MethodFamily::Polygons;
    method.kinds = {PrimitiveKind::Polygon};
    method.effects = {Effect::Clipping};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::TopLeft};
    method.fillRuleReason
        = QStringLiteral("a sample on the boundary of a polygon is in or out by the parity of "
                         "crossings, which is certain only for a sample displaced to the right "
                         "and a little downward");
    return method;
}

Method polygonParityMethod()
{
    Method method = polygonMethod(methodOf<ParityKernel>());
    method.id = QStringLiteral("polygon-parity");
    method.title = QStringLiteral("Polygon by parity");
    method.source = QStringLiteral("Scan Conversion slides, “Scan Conversion: A General "
                                   "Algorithm”");
    method.summary = QStringLiteral("Intersects each row with the active edges, sorts the "
                                    "crossings in x, and fills by their parity or winding number.");
    method.remarks
        = {QStringLiteral("concave"), QStringLiteral("self-crossing"), QStringLiteral("holes"),
           QStringLiteral("even-odd"), QStringLiteral("non-zero")};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
