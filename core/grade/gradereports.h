// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradereport.h"

namespace pixelplumb {

/// Gradescope's format: of one submission, and of all, by name.
QByteArray gradescopeOf(const GradedSubmission &submission, const Assignment &assignment);
QByteArray gradescopeOf(const GradeReport &report);
/// A test suite a submission, a test case a check.
QByteArray junitOf(const GradeReport &report);
/// A line a submission.
QByteArray csvOf(const GradeReport &report);
/// One page with pictures, read from the folder of results, and without script.
QByteArray pageOf(const GradeReport &report, const QString &results);

/// All of them, into the folder of results: results.json, gradescope/ID.json, junit.xml,
/// grades.csv, index.html.
std::optional<InputError> writeReports(const QString &results, const GradeReport &report);

} // namespace pixelplumb
