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
    bool isSamePictures = false; ///< were to be drawn, under the same settings
    bool isMissing = false; ///< it was measured before, and is not after

    bool isAccuracyChanged() const { return wrongBefore != wrongAfter; }
    bool isLessAccurate() const
    {
        return isSamePictures && wrongBefore && wrongAfter && *wrongBefore < *wrongAfter;
    }
};

struct LabComparison {
    std::vector<LabRowComparison> rows; ///< of either study
    /// What else differs: machine, build, seed, own scene, settings. Times of other work are not
    /// comparable.
    QStringList remarks;

    std::int64_t count(LabChange change) const;
    std::int64_t countLessAccurate() const;
    std::int64_t countMissing() const;
    /// Anything is slower, less accurate or missing.
    bool isWorse() const;
};

LabComparison compareStudies(const Study &before, const Study &after);

/// Aligned lines for a terminal.
QStringList textOf(const LabComparison &comparison);

} // namespace pixelplumb
