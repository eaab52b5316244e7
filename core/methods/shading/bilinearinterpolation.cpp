// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/shading/interpolationtraces.h"

namespace pixelplumb {

Method bilinearInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Bilinear, ShadedMethod::Bilinear>();
    method.id = "interpolate-bilinear";
    method.title = QT_TRANSLATE_NOOP("core", "Bilinear interpolation");
    method.source = "Scan Conversion slides, “1. Bilinear Interpolation”";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Interpolates along both edges and then along the column, "
                                       "each by adding a rate; what is covered is exact.");
    return method;
}

Method bilinearRowsInterpolationMethod()
{
    Method method = plainInterpolationMethod<InterpolationForm::BilinearRows>();
    method.id = "interpolate-bilinear-rows";
    method.title = QT_TRANSLATE_NOOP("core", "Bilinear interpolation by rows");
    method.source = "Scan Conversion slides, “1. Bilinear Interpolation” (“along LH and RH edges, "
                    "as a function of y”)";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Interpolates along the left and the right edge and then along the "
                            "row, each by adding a rate; what is covered is exact.");
    return method;
}

} // namespace pixelplumb
