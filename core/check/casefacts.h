// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"

#include <QStringList>

#include <span>

namespace pixelplumb {

/// "12 7 0"
QString numbersText(std::span<const std::int64_t> values);

/// Appends "pixel count 1003 instead of 1004" unless both are the same or nothing is expected.
void compare(QStringList &shortfalls, const QString &what, const QString &found,
             const QString &expected);
void compare(QStringList &shortfalls, const QString &what, std::int64_t found,
             std::optional<std::int64_t> expected);

/// Compares the picture's count, hashes and channel sums with those that the facts give.
void comparePicture(QStringList &shortfalls, const ExpectedFacts &facts,
                    const CasePicture &picture);

/// How often each pixel is covered; x and y in the case's coordinates.
using CoverageTimes = std::map<std::array<std::int64_t, 2>, int>;
void addCoverage(CoverageTimes &times, const CasePicture &picture);
/// How many pixels are covered once, twice, …
std::map<int, std::int64_t> histogramOf(const CoverageTimes &times);
void compareHistogram(QStringList &shortfalls, const std::map<int, std::int64_t> &found,
                      const std::map<int, std::int64_t> &expected);

} // namespace pixelplumb
