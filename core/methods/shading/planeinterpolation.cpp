// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/shading/interpolationtraces.h"

namespace pixelplumb {

Method planeInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Plane, ShadedMethod::Plane>();
    method.id = "interpolate-plane";
    method.title = QT_TRANSLATE_NOOP("core", "Plane equation");
    method.source = "Scan Conversion slides, “2. Plane Equation”";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Evaluates v = a·x + b·y + c of the plane through the three "
                                       "values at each sample; what is covered is exact.");
    return method;
}

Method barycentricInterpolationMethod()
{
    Method method
        = interpolationMethod<InterpolationForm::Barycentric, ShadedMethod::Barycentric>();
    method.id = "interpolate-barycentric";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric interpolation");
    method.source = "Scan Conversion slides, “3. Barycentric Coordinates” and “Computing "
                    "Barycentric Coordinates”";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Weights the three vertices' values with α, β and γ at each "
                                       "sample; what is covered is exact.");
    return method;
}

} // namespace pixelplumb
