// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"

namespace pixelplumb {

/// Gradescope's format, for one submission or for all, by name.
QByteArray gradescopeOf(const GradedSubmission &submission, const Assignment &assignment);
QByteArray gradescopeOf(const GradeReport &report);
/// JUnit: a test suite for each submission, a test case for each check.
QByteArray junitOf(const GradeReport &report);
/// One line for each submission.
QByteArray csvOf(const GradeReport &report);
/// One page without scripts, with the pictures from the folder of results.
QByteArray pageOf(const GradeReport &report, const QString &results);

/// Writes all reports into the folder of results: results.json, gradescope/ID.json, junit.xml,
/// grades.csv, index.html.
std::optional<InputError> writeReports(const QString &results, const GradeReport &report);

} // namespace pixelplumb
