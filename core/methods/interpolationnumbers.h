// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationsteps.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

/// The numbers of the three forms of interpolation, for the channels that are carried.
NumberTable<InterpolationSetUpState> interpolationSetUpNumbers(InterpolationForm form,
                                                               const CarriedChannels &carried);
NumberTable<InterpolationSpanState> interpolationSpanNumbers(InterpolationForm form,
                                                             const CarriedChannels &carried);
NumberTable<InterpolationSampleState> interpolationSampleNumbers(InterpolationForm form,
                                                                 const CarriedChannels &carried);

} // namespace pixelplumb
