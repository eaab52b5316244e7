// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationsteps.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

/// The numbers of the three forms of interpolation.
NumberTable<InterpolationSetUpState> interpolationSetUpNumbers(InterpolationForm form);
NumberTable<InterpolationSpanState> interpolationSpanNumbers(InterpolationForm form);
NumberTable<InterpolationSampleState> interpolationSampleNumbers(InterpolationForm form);

} // namespace pixelplumb
