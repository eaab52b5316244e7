// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/walks/edgewalktraces.h"

namespace pixelplumb {

Method constantRateRowWalkMethod()
{
    Method method = edgeWalkMethod<ConstantRateWalk<SpanAxis::Row>>();
    method.id = "row-walk-constant-rate";
    method.title = QT_TRANSLATE_NOOP("core", "Row edge walking, constant ΔR");
    method.family = MethodFamily::StableForms;
    method.source = "stable form of the Rasterization slides, “Edge Walking”, by the Scan "
                    "Conversion slides, “2. Plane Equation”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Walks the rows between two edges, the largest y first, with ΔR computed once from the "
        "plane through the three vertices, so that short rows cannot blow it up.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::TopLeft, FillRule::Open};
    return method;
}

} // namespace pixelplumb
