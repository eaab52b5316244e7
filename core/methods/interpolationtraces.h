// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationmethod.h"

/// Recording an interpolation is compiled in one source, not beside the drawing: nothing of it is
/// timed, and the optimiser takes twice as long for what is.
namespace pixelplumb {

extern template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Bilinear>>;
extern template TraceFunction traceWith<InterpolationKernel<InterpolationForm::BilinearRows>>;
extern template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Plane>>;
extern template TraceFunction traceWith<InterpolationKernel<InterpolationForm::Barycentric>>;
extern template TraceFunction traceCarried<InterpolationForm::Bilinear>;
extern template TraceFunction traceCarried<InterpolationForm::BilinearRows>;
extern template TraceFunction traceCarried<InterpolationForm::Plane>;
extern template TraceFunction traceCarried<InterpolationForm::Barycentric>;

} // namespace pixelplumb
