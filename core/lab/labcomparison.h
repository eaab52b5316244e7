// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb {

/// Whether two measurements of time can be told apart: their middle halves do not overlap.
enum class LabChange : std::uint8_t { WithinSpread, Faster, Slower, NotComparable };
QString nameOf(LabChange change); ///< "within spread", "faster", …

/// The same row of two studies.
struct LabRowComparison {
    QString contender;
    QString family;
    std::optional<Spread> before; ///< ns a pixel
    std::optional<Spread> after;
    std::optional<double> timesBefore; ///< after over before, medians
    LabChange change = LabChange::NotComparable;
    std::optional<double> wrongBefore; ///< pixels of a million
    std::optional<double> wrongAfter;

    bool isAccuracyChanged() const { return wrongBefore != wrongAfter; }
};

struct LabComparison {
    std::vector<LabRowComparison> rows; ///< of either study
    /// What else differs: machine, build, seed, own scene, settings. Times of other work are not
    /// comparable.
    QStringList remarks;

    std::int64_t count(LabChange change) const;
};

LabComparison compareStudies(const Study &before, const Study &after);

/// Aligned lines for a terminal.
QStringList textOf(const LabComparison &comparison);

} // namespace pixelplumb
