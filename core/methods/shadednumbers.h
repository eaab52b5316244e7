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

/// The numbers of a scene's lights, its viewer and a triangle's material; and, at a sample, of the
/// light that meets it: N before and after unit length, L, V and H, and each light's terms.
void appendLightSources(NumberTable<ShadedSetUpState> &table,
                        const std::shared_ptr<const Appearance> &appearance);
void appendLight(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// Read where the sample was written, a single one.
using ReadOfSample = std::function<Quantity(const ShadedSampleState &)>;
ReadOfSample ofWritten(const ReadOfSample &read);

/// What a triangle carries, which column is in hand, and what becomes of a sample, in words.
void tellShaded(StepWords &words, const ShadedSetUpState &state);
void tellShaded(StepWords &words, const ShadedSpanState &state);
void tellShaded(StepWords &words, const ShadedSampleState &state);

/// "R", "z", "N_x": a channel as its vertices have it; "R_w", "q": as it is interpolated where
/// perspective is corrected, divided by w.
const QString &shadedName(Channel channel);
QString linearName(Channel channel, const EffectSet &effects);
/// "levels", or empty.
QString unitOf(Channel channel);

} // namespace pixelplumb
