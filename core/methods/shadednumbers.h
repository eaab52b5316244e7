// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shadedstate.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// The numbers of shaded triangles: those that the effects in scope call for, and no others.
NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope);
NumberTable<ShadedSpanState> shadedSpanNumbers(const ShadedScope &scope);
NumberTable<ShadedSampleState> shadedSampleNumbers(const ShadedScope &scope);

/// What a triangle carries, which column is in hand, and what becomes of a sample, in words.
void tellShaded(StepWords &words, const ShadedSetUpState &state);
void tellShaded(StepWords &words, const ShadedSpanState &state);
void tellShaded(StepWords &words, const ShadedSampleState &state);

/// "R", "z", "N_x": a channel as its vertices have it; "R_w", "q": as it is interpolated where
/// perspective is corrected, divided by w.
const QString &shadedName(Channel channel);
QString linearName(Channel channel, const EffectSet &effects);

} // namespace pixelplumb
