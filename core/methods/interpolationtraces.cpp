// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationtraces.h"

namespace pixelplumb {

template TraceFunction traceCarried<InterpolationForm::Bilinear>;
template TraceFunction traceCarried<InterpolationForm::BilinearRows>;
template TraceFunction traceCarried<InterpolationForm::Plane>;
template TraceFunction traceCarried<InterpolationForm::Barycentric>;

} // namespace pixelplumb
