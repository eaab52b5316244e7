// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"
#include "core/scene/result.h"

namespace pixelplumb {

/// Of the JSON that writeStudy() writes, and the only one that readStudy() reads.
inline constexpr int labFileVersion = 4;

/// The same study, the same bytes.
QByteArray writeStudy(const Study &study);
Result<Study> readStudy(const QByteArray &text);

/// The accuracy alone: the same seed, the same bytes, on every run.
QByteArray writeAccuracy(const Study &study);

/// A line a row, numbers with a decimal point; what was not measured is an empty field.
QByteArray csvOf(const Study &study);
/// The same with the accuracy alone.
QByteArray accuracyCsvOf(const Study &study);

} // namespace pixelplumb
