// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

namespace pixelplumb {

Method bezierFillMethod()
{
    Method method = polygonMethod(methodOf<BezierFillKernel>());
    method.id = "bezier-fill";
    method.title = QT_TRANSLATE_NOOP("core", "Bézier path: filled");
    method.family = MethodFamily::Curves;
    method.source = "Rasterization slides, “Output Primitives” (other curves, also filled); Scan "
                    "Conversion slides, “Scan Conversion: A General Algorithm”";
    method.pseudocode = parityPseudocode();
    method.pseudocode.insert(
        method.pseudocode.begin(),
        {0,
         "given: the edges of each piece, chords that leave it by 1/32 px at most; a "
         "straight edge where two pieces do not meet",
         {Moment::SetUp}});
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Closes a path of Bézier pieces, takes each as a chain of chords, and fills these by "
        "parity or winding number; the truth is that of the curves themselves.");
    method.remarks = {"self-crossing", "even-odd", "non-zero", "chords within 1/32 px"};
    method.kinds = {PrimitiveKind::Bezier};
    method.stableArithmetics = {};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
