// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/search/measure.h"

#include <QStringList>

namespace pixelplumb::search {

/// What is wrong with one case in every arithmetic and rule, as lines of the record:
///     "t1 float32 closed": {"missing": 2, "wrong_bytes": 7}
/// A combination that is right has no line.
QStringList recordLines(const HardCase &hardCase);

/// The whole record of several files of cases as JSON, a line a combination.
struct RecordedFile {
    QString name; ///< "hard_cases.json"
    QStringList lines;
};
QByteArray recordText(const std::vector<RecordedFile> &files);

/// The lines of one file of a record that recordText wrote.
QStringList linesOf(const QByteArray &record, const QString &fileName);

} // namespace pixelplumb::search
