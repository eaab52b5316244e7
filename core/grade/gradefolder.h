// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradereport.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

/// The share of the submissions that one of several machines grades: chosen by name, so it is
/// stable.
struct GradeShard {
    int number = 1; ///< 1 … of
    int of = 1;
};

struct GradingOrder {
    QString submissions; ///< a folder
    QString results; ///< a folder, made if need be
    QString version; ///< of this program: a new version grades anew
    int jobs = 1; ///< threads
    GradeShard shard = {};
};

/// Grades each submission of the folder unless the results already hold its grade from the same
/// version, assignment and bytes: an interrupted run resumes where it stopped. Each grade is
/// written at once, the reports at the end. None where the listener, who hears how many submissions
/// are done, ended it. A submission that cannot be graded, neither alongside others nor alone, says
/// so and is graded again next time. Equal submissions give equal bytes.
Result<std::optional<GradeReport>> gradeFolder(const GradingOrder &order,
                                               const Assignment &assignment,
                                               const ProgressListener &listener = {});

/// How complete the merged parts must be.
enum class MergeExtent {
    Whole, ///< an error says which parts or submissions are missing
    Partial, ///< the report says what is missing
};

/// Joins the results of shards, with their reviews, into a new folder.
Result<GradeReport> mergeGrades(const QStringList &parts, const QString &results,
                                MergeExtent extent = MergeExtent::Whole);

} // namespace pixelplumb
