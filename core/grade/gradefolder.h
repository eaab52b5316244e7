// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradereport.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

/// The part of the submissions that one of several machines grades: a stable share, by name.
struct GradeShard {
    int number = 1; ///< 1 … of
    int of = 1;
};

struct GradingOrder {
    QString submissions; ///< a folder
    QString results; ///< a folder, made if need be
    QString version; ///< of this program: another one grades anew
    int jobs = 1; ///< threads
    GradeShard shard = {};
};

/// Grades each submission of the folder whose grade is not in the results yet, or was given by
/// another version, for another assignment or other bytes: a run that was ended is taken up where
/// it stopped. Each grade is written as soon as it is given, the reports at the end. None where the
/// listener, who hears how many submissions are done, ended it. What could not be
/// graded, beside others and alone, says so and is graded again the next time. The same
/// submissions, the same bytes.
Result<std::optional<GradeReport>> gradeFolder(const GradingOrder &order,
                                               const Assignment &assignment,
                                               const ProgressListener &listener = {});

/// What parts that are merged are to be together.
enum class MergeExtent {
    Whole, ///< an error says which parts or submissions are missing
    Partial, ///< the report says it
};

/// Joins the results of shards, with their reviews, into a folder of their own.
Result<GradeReport> mergeGrades(const QStringList &parts, const QString &results,
                                MergeExtent extent = MergeExtent::Whole);

} // namespace pixelplumb
