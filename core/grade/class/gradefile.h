// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"

namespace pixelplumb {

class ResultsFolder;

/// The format of the results' JSON, and the newest that is read.
inline constexpr int gradesFormat = 1;

/// A submission's own file, written and sealed by grading (seal.h), without the review.
/// `assignment` is the text of writeAssignment(). A file of another assignment, or one that was
/// edited, is an error.
QByteArray writeGradedSubmission(const GradedSubmission &submission, const QByteArray &assignment);
Result<GradedSubmission> readGradedSubmission(const QByteArray &text, const QByteArray &assignment);

/// The digest of a picture's bytes, for GradedScene.
QString pictureDigestOf(const QByteArray &picture);
/// The first of a submission's pictures that is missing or differs from what grading wrote.
std::optional<InputError> changedPictureOf(const GradedSubmission &submission,
                                           const ResultsFolder &results);

/// The path of the assignment in a folder of results, and of a submission's grade.
QString assignmentFileOf(const QString &results);
QString submissionFileOf(const QString &results, const QString &id);

/// The files that are written into a folder of results, outside its folders.
QStringList resultFiles();

/// The names of all submissions, sealed; those without a grade are missing in the report.
QByteArray writeSubmissionList(const QStringList &names);

/// Why results must not be written to the folder: a file that has the name of one is an input, or
/// was not written by grading. None where they may be.
std::optional<InputError> refusalOfResults(const ResultsFolder &folder);

/// Reads a folder of results, complete or as far as its grading came, with the reviews.
Result<GradeReport> readGrades(const QString &results);

/// Writes the assistant's reviews of submissions, atomically.
std::optional<InputError> writeReviews(const QString &results, const GradeReport &report);

} // namespace pixelplumb
