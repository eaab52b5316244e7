// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shadedstate.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

#include <functional>
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

/// Which texels are read. The formulas hold where the place is inside of the texture.
void appendTexels(NumberTable<ShadedSampleState> &table, const ShadedScope &scope);

/// Read where the sample was written, a single one.
using ReadOfSample = std::function<Quantity(const ShadedSampleState &)>;
ReadOfSample ofWritten(const ReadOfSample &read);

/// A number that no exact one stands beside.
NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula, NumberGroup group);

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
/// What the plane through the values % of the vertices changes by from column to column, and from
/// row to row.
QString alongRowsText();
QString alongColumnsText();

} // namespace pixelplumb
