// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

namespace pixelplumb {

Method textOutlinesMethod()
{
    Method method = polygonMethod(methodOf<TextKernel>());
    method.id = "text-outlines";
    method.title = QT_TRANSLATE_NOOP("core", "Text as outlines");
    method.family = MethodFamily::Others;
    method.source = "Rasterization slides, “Output Primitives” (characters); Scan Conversion "
                    "slides, “Scan Conversion: A General Algorithm”";
    method.pseudocode = parityPseudocode();
    method.pseudocode.insert(
        method.pseudocode.begin(),
        {0, "given: the contours, outlines of the glyphs in the font", {Moment::SetUp}});
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Takes the outlines of the glyphs from a font and fills "
                                       "them as one polygon by winding number.");
    method.remarks = {"text", "non-zero"};
    method.kinds = {PrimitiveKind::Text};
    method.fills = {};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    return method;
}

} // namespace pixelplumb
