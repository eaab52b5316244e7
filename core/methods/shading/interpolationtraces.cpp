// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationtraces.h"

namespace pixelplumb {

template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Bilinear>>;
template TraceFunction traceWith<InterpolationKernel<InterpolationForm::BilinearRows>>;
template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Plane>>;
template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Barycentric>>;
template TraceFunction traceCarried<InterpolationForm::Bilinear>;
template TraceFunction traceCarried<InterpolationForm::BilinearRows>;
template TraceFunction traceCarried<InterpolationForm::Plane>;
template TraceFunction traceCarried<InterpolationForm::Barycentric>;

} // namespace pixelplumb
