// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"

#include <QStringList>

#include <map>

/// What the rounding arithmetics get wrong in each hard case: every method × arithmetic × fill rule
/// that the case has facts for and that is not claimed stable. A combination that is right has no
/// entry.
namespace pixelplumb::shortfalls {

/// How wrong a drawing of a case with triangles is; all zero if it is right.
struct Counts {
    std::int64_t missing = 0; ///< pixels, summed over triangles, frames or places
    std::int64_t extra = 0;
    std::int64_t wrongBytes = 0; ///< pixels that both cover, in another colour
    std::int64_t gaps = 0; ///< mesh: pixels that no drawn triangle covers, but one of the truth's
                           ///< does
    std::int64_t overdraw = 0; ///< mesh: how many times too often pixels are covered
    std::int64_t extraToggles = 0; ///< sequence: flicker, changed pixels beyond the true changes
    std::int64_t extraPictures = 0; ///< translation: number of different pictures beyond one
};

/// The pictures of a case with triangles, one per triangle, frame or place, each read from the
/// canvas' corner: 0 where nothing was written.
using Pictures = std::vector<std::vector<QRgb>>;
Pictures picturesOf(const HardCase &hardCase, const ScanSettings &settings, const Drawing &drawing);
/// What the pictures get wrong beside the true ones.
Counts countsOf(const HardCase &hardCase, const Pictures &drawn, const Pictures &truth);

/// The contenders that fall short in one case, grouped by what they get wrong: "2 missing, 3 extra"
/// → "column-scan float32 closed".
using CaseRecord = std::map<QString, QStringList>;
/// Keyed by the case's id.
using FileRecord = std::map<QString, CaseRecord>;
/// Keyed by the name of the case file.
using Record = std::map<QString, FileRecord>;

/// Measures every contender on the case, or only those of the method with this id.
CaseRecord shortfallsOf(const HardCase &hardCase, QStringView methodId = {});

/// The record as JSON, one line per case and shortfall.
QByteArray textOf(const Record &record);
/// Empty if the text is no record.
Record readRecord(const QByteArray &text);

/// "sliver_fibonacci: column-scan float32 closed: 2 missing, 3 extra", sorted.
QStringList linesOf(const FileRecord &file);

} // namespace pixelplumb::shortfalls
