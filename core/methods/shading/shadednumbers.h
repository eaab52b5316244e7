// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/shadedstate.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

#include <functional>
#include <initializer_list>
#include <optional>

namespace pixelplumb {

/// The scope of an interpolation by itself.
ShadedScope interpolationScope(InterpolationForm form, const CarriedChannels &carried = {});

/// The numbers of shaded triangles: those that the effects in scope call for, and no others. An
/// interpolation by itself is shading without effects.
NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope);
NumberTable<ShadedSpanState> shadedSpanNumbers(const ShadedScope &scope);
NumberTable<ShadedSampleState> shadedSampleNumbers(const ShadedScope &scope);

/// Append the numbers of a scene's lights, its viewer and a triangle's material; and, at a sample,
/// of its light: N before and after unit length, L, V and H, and each light's terms.
void appendLightSources(NumberTable<ShadedSetUpState> &table,
                        const std::shared_ptr<const Appearance> &appearance);
void appendLight(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// Appends a, b and c of the planes of the form's values, or of its weights, by vertex; of an
/// interpolation by itself also what they are made from.
void appendPlanes(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope);

/// Appends what is painted, how it is blended, and the mean if the pixel has several samples.
void appendPixel(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// How a byte follows from the interpolated levels of channels, % standing for each: clamped where
/// one leaves 0 … 255; empty where one is NaN.
QString shadedByteFormula(const ShadedSampleState &state,
                          std::initializer_list<std::size_t> channels, ByteRounding rounding);
/// shadedByteFormula() of R, G and B, after a name: "base_% = ".
QString bytesFormula(const ShadedSampleState &state, ByteRounding rounding, const QString &name);

/// Appends which texels are read.
void appendTexels(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// Reads only where a single sample was written.
using ReadOfSample = std::function<Quantity(const ShadedSampleState &)>;
ReadOfSample ofWritten(const ReadOfSample &read);

void appendPlain(NumberTable<ShadedSampleState> &table, const QString &id, const QString &toolTip,
                 const QString &formula, const ReadOfSample &read,
                 NumberGroup group = NumberGroup::FirstColour);

using ColourOfSample = std::function<std::optional<Colour>(const ShadedSampleState &)>;
using FormulaOfSample = std::function<QString(const ShadedSampleState &)>;
/// Appends R, G and B of bytes, "t_R"; % stands for the letter. `formulaIn` gives the formula of
/// states that have another one, else an empty text.
void appendBytes(NumberTable<ShadedSampleState> &table, const QString &name, const QString &toolTip,
                 const QString &formula, const ColourOfSample &read,
                 const FormulaOfSample &formulaIn = {});

/// Says what a triangle carries, which column is current, and what becomes of a sample.
void tellShaded(StepWords &words, const ShadedSetUpState &state);
void tellShaded(StepWords &words, const ShadedSpanState &state);
void tellShaded(StepWords &words, const ShadedSampleState &state);

/// "R", "z", "N_x": a channel as its vertices have it; "R_w", "q": as it is interpolated where
/// perspective is corrected, divided by w.
const QString &shadedName(Channel channel);
QString linearName(Channel channel, const EffectSet &effects);
/// "levels", "levels/row"; empty for other channels.
QString unitOf(Channel channel, const QString &per = {});
/// The change along x or y of the plane through the vertices' values %.
QString planeSlope(QChar axis);
/// A number that is 0 throughout, because no vertex has anything in its channel, needs no formula
/// in an interpolation by itself.
NumberRow<ShadedSetUpState>::Specify ifCarried(const ShadedScope &scope, std::size_t at);

} // namespace pixelplumb
