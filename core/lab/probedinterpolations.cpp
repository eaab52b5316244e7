// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/levelobserver.h"
#include "core/methods/interpolationkernel.h"

namespace pixelplumb {

std::span<const ProbedMethod> probedInterpolations()
{
    using enum InterpolationForm;
    static constexpr ProbedMethod table[] = {
        {"interpolate-bilinear", probeWith<InterpolationKernel<Bilinear>>},
        {"interpolate-bilinear-rows", probeWith<InterpolationKernel<BilinearRows>>},
        {"interpolate-plane", probeWith<InterpolationKernel<Plane>>},
        {"interpolate-barycentric", probeWith<InterpolationKernel<Barycentric>>},
    };
    return table;
}

} // namespace pixelplumb
