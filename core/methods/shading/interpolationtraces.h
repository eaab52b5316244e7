// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/interpolationmethod.h"

/// Recording an interpolation is compiled in a source of its own, apart from drawing: it is not
/// timed, and the optimiser takes twice as long over timed code.
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
