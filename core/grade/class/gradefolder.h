// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

struct GradingOrder {
    QString submissions; ///< a folder
    QString results; ///< a folder, made if need be
    QString version; ///< of this program: a new version grades anew
    int jobs = 1; ///< threads
    QStringList names = {}; ///< of the submissions to be graded; empty: all
};

/// Grades each submission of the folder unless the results already hold its grade from the same
/// version, assignment and bytes: an interrupted run resumes where it stopped. Each grade is
/// written at once. Several runs may grade into one folder of results: each grades what no other
/// has claimed, and the last to end writes the reports, which are those of one run alone. None
/// where others are still at work, or where the listener, who hears how many submissions are done,
/// ended it. A submission that cannot be graded, neither alongside others nor alone, says so and is
/// graded again next time. Equal submissions give equal bytes.
Result<std::optional<GradeReport>> gradeFolder(const GradingOrder &order,
                                               const Assignment &assignment,
                                               const ProgressListener &listener = {});

} // namespace pixelplumb
