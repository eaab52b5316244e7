// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"
#include "core/grade/gradereport.h"

namespace pixelplumb {

class ResultsFolder;

/// The format of the results' JSON, and the newest that is read.
inline constexpr int gradesFormat = 1;

/// A submission's own file, written and sealed by grading (seal.h), without the review.
/// `assignment` is the text of writeAssignment(). A file of another assignment, or one that was
/// edited, is an error.
QByteArray writeGradedSubmission(const GradedSubmission &submission, const QByteArray &assignment);
Result<GradedSubmission> readGradedSubmission(const QByteArray &text, const QByteArray &assignment);

/// Which submissions a folder of results covers: all that existed when they were graded, and this
/// run's share of them.
inline constexpr int mostParts = 10'000;
struct GradedPart {
    int number = 1; ///< 1 … of
    int of = 1;
    QStringList submissions; ///< all names, including those of other parts

    friend bool operator==(const GradedPart &, const GradedPart &) = default;
};
QByteArray writeGradedPart(const GradedPart &part); ///< with its seal
/// Reads the part of a folder of results; an error where there is none, or an edited one.
Result<GradedPart> readGradedPart(const QString &results);

/// The digest of a picture's bytes, for GradedScene.
QString pictureDigestOf(const QByteArray &picture);
/// The first of a submission's pictures that is missing or differs from what grading wrote.
std::optional<InputError> changedPictureOf(const GradedSubmission &submission,
                                           const ResultsFolder &results);

/// The path of the assignment in a folder of results, and of a submission's grade.
QString assignmentFileOf(const QString &results);
QString submissionFileOf(const QString &results, const QString &id);

/// Makes a folder of results, or resumes an existing one, and records which part it is. An error
/// where grading did not write the files that have the names of results. Other runs are refused
/// while the descriptor is open.
Result<Descriptor> beginResults(const QString &results, const GradedPart &part);

/// Reads a folder of results, complete or as far as its grading came, with the reviews.
Result<GradeReport> readGrades(const QString &results);

/// Writes the assistant's reviews of submissions, atomically.
std::optional<InputError> writeReviews(const QString &results, const GradeReport &report);

} // namespace pixelplumb
