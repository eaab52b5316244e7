// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"
#include "core/grade/gradereport.h"

namespace pixelplumb {

class ResultsFolder;

/// Of the JSON of results, and the newest that is read.
inline constexpr int gradesFormat = 1;

/// A submission's own file, which grading writes and seals (seal.h); without the review. The
/// assignment is what writeAssignment() writes. A text of another one, or that somebody has edited,
/// is an error.
QByteArray writeGradedSubmission(const GradedSubmission &submission, const QByteArray &assignment);
Result<GradedSubmission> readGradedSubmission(const QByteArray &text, const QByteArray &assignment);

/// Which submissions a folder of results is of: what was there when they were graded, and the share
/// of them that this run had.
inline constexpr int mostParts = 10'000;
struct GradedPart {
    int number = 1; ///< 1 … of
    int of = 1;
    QStringList submissions; ///< the names of all, those of the other parts among them

    friend bool operator==(const GradedPart &, const GradedPart &) = default;
};
QByteArray writeGradedPart(const GradedPart &part); ///< with its seal
/// That of a folder of results; an error where there is none, or an edited one.
Result<GradedPart> readGradedPart(const QString &results);

/// Of a picture's bytes, as GradedScene has it.
QString pictureDigestOf(const QByteArray &picture);
/// The first of a submission's pictures that is not what grading wrote, or no longer there.
std::optional<InputError> changedPictureOf(const GradedSubmission &submission,
                                           const ResultsFolder &results);

/// The path of the assignment in a folder of results, and of a submission's grade.
QString assignmentFileOf(const QString &results);
QString submissionFileOf(const QString &results, const QString &id);

/// Makes a folder of results, or takes up one that is there, and says which part it is. An error
/// where what stands under the names of results was not written by grading. Other runs are refused
/// as long as the descriptor is open.
Result<Descriptor> beginResults(const QString &results, const GradedPart &part);

/// A folder of results, whole or as far as its grading came, with the reviews.
Result<GradeReport> readGrades(const QString &results);

/// What the assistant said of submissions, atomically.
std::optional<InputError> writeReviews(const QString &results, const GradeReport &report);

} // namespace pixelplumb
