// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shadedstate.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

#include <functional>
#include <initializer_list>
#include <optional>

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

/// a, b and c of the planes of the form's values, or of its weights, by the vertices.
void appendPlanes(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope);

/// What is painted, how it is blended, and the mean where the pixel has several samples.
void appendPixel(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// How a byte comes from the interpolated levels of channels, % standing for each: clamped where
/// one of them leaves 0 … 255; empty where one is no number.
QString shadedByteFormula(const ShadedSampleState &state,
                          std::initializer_list<std::size_t> channels, ByteRounding rounding);
/// The same of R, G and B, behind a name: "base_% = ".
QString bytesFormula(const ShadedSampleState &state, ByteRounding rounding, const QString &name);

/// Which texels are read.
void appendTexels(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// Read where the sample was written, a single one.
using ReadOfSample = std::function<Quantity(const ShadedSampleState &)>;
ReadOfSample ofWritten(const ReadOfSample &read);

/// A number that no exact one stands beside.
NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula, NumberGroup group);
void appendPlain(NumberTable<ShadedSampleState> &table, const QString &id, const QString &toolTip,
                 const QString &formula, const ReadOfSample &read,
                 NumberGroup group = NumberGroup::FirstColour);

using ColourOfSample = std::function<std::optional<Colour>(const ShadedSampleState &)>;
using FormulaOfSample = std::function<QString(const ShadedSampleState &)>;
/// R, G and B of bytes, "t_R"; % stands for the letter. `formulaIn` gives the formula of states
/// that have another one, and is empty for the others.
void appendBytes(NumberTable<ShadedSampleState> &table, const QString &name, const QString &toolTip,
                 const QString &formula, const ColourOfSample &read,
                 const FormulaOfSample &formulaIn = {});

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
/// What the plane through the values % of the vertices changes by along x or y.
QString planeSlope(QChar axis);

} // namespace pixelplumb
