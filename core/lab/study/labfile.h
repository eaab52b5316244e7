// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"
#include "core/scene/text/result.h"

namespace pixelplumb {

/// The version of the JSON that writeStudy() writes, the only one that readStudy() reads.
inline constexpr int labFileVersion = 4;

/// The same study gives the same bytes.
QByteArray writeStudy(const Study &study);
Result<Study> readStudy(const QByteArray &text);

/// Only the accuracy: the same seed gives the same bytes on every run.
QByteArray writeAccuracy(const Study &study);

/// One line per row, numbers with a decimal point; what was not measured is an empty field.
QByteArray csvOf(const Study &study);
/// Like csvOf(), with only the accuracy.
QByteArray accuracyCsvOf(const Study &study);

} // namespace pixelplumb
