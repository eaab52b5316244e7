// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/gradefile.h"
#include "core/grade/gradefolder.h"
#include "core/grade/gradereports.h"
#include "core/grade/resultsfolder.h"
#include "core/grade/showntext.h"
#include "core/scene/outputfolder.h"

#include <QSet>

#include <algorithm>

namespace pixelplumb {

namespace {

std::optional<InputError> copySubmission(const ResultsFolder &part, const ResultsFolder &results,
                                         const GradedSubmission &submission)
{
    QStringList files = {submissionFile(submission.id)};
    for (const GradedScene &scene : submission.scenes) {
        if (!scene.picture.isEmpty())
            files += scene.picture;
    }
    for (const QString &file : files) {
        const Result<QByteArray> content = part.read(file);
        if (!content)
            return content.error();
        if (auto error = results.write(file, *content))
            return error;
    }
    return std::nullopt;
}

/// A folder to be merged.
struct MergedPart {
    QString folder;
    GradeReport report;
    GradedPart part; ///< number 0: it does not say
};

Result<std::vector<MergedPart>> readParts(const QStringList &folders, const QString &results)
{
    std::vector<MergedPart> parts;
    for (const QString &folder : folders) {
        if (lieInEachOther(folder, results))
            return InputError{folder, QStringLiteral("the results and this part lie in each other"),
                              QStringLiteral("another folder for the whole")};
        Result<GradeReport> report = readGrades(folder);
        if (!report)
            return report.error();
        if (!parts.empty() && report->assignment != parts.front().report.assignment)
            return InputError{folder, QStringLiteral("is of another assignment"),
                              QStringLiteral("that of %1").arg(folders.front())};
        const auto part = readGradedPart(folder);
        parts.push_back({folder, std::move(*report), part ? *part : GradedPart{0, 0, {}}});
    }
    return parts;
}

/// An error for the first submission that is in two of the parts.
std::optional<InputError> doubledIn(const std::vector<MergedPart> &parts)
{
    QSet<QString> ids;
    for (const MergedPart &each : parts) {
        for (const GradedSubmission &submission : each.report.submissions) {
            if (ids.contains(submission.id))
                return InputError{
                    each.folder, QStringLiteral("“%1” is in two of the parts").arg(submission.name),
                    QStringLiteral("each submission once")};
            ids += submission.id;
        }
    }
    return std::nullopt;
}

/// The numbers of the missing parts, among those that share the first one's submissions.
QStringList missingNumbers(const GradedPart &like, const std::vector<MergedPart> &parts)
{
    QSet<int> there;
    for (const MergedPart &each : parts) {
        if (each.part.of == like.of && each.part.submissions == like.submissions)
            there += each.part.number;
    }
    QStringList missing;
    for (int number = 1; number <= like.of; ++number) {
        if (!there.contains(number))
            missing += QString::number(number);
    }
    return missing;
}

/// Why the parts are not complete; none where they are. `missing`: known submissions without a
/// grade.
std::optional<InputError> incompleteness(const std::vector<MergedPart> &parts,
                                         const QStringList &missing)
{
    const QString expected = QStringLiteral("all parts, or --partial");
    for (const MergedPart &each : parts) {
        if (each.part.of == 0)
            return InputError{each.folder,
                              QStringLiteral("does not say which part it is: part.json is missing"),
                              expected};
    }
    if (missing.isEmpty())
        return std::nullopt;
    const QString which = fewNames(missing);
    const QString ungraded = missing.size() == 1
        ? QStringLiteral("1 submission has no grade: ") + which
        : QStringLiteral("%1 submissions have no grade: %2").arg(missing.size()).arg(which);
    for (const MergedPart &each : parts) {
        const MergedPart &first = parts.front();
        if (each.part.of == first.part.of && each.part.submissions != first.part.submissions)
            return InputError{
                each.folder,
                QStringLiteral("is of another list of submissions than %1 (%2 and %3); %4")
                    .arg(first.folder, QString::number(each.part.submissions.size()),
                         QString::number(first.part.submissions.size()), ungraded),
                QStringLiteral("parts that were graded of the same submissions, or --partial")};
    }
    for (const MergedPart &each : parts) {
        const QStringList numbers = missingNumbers(each.part, parts);
        if (!numbers.isEmpty())
            return InputError{{},
                              QStringLiteral("of %1 parts there is no %2; %3")
                                  .arg(each.part.of)
                                  .arg(numbers.join(QStringLiteral(", ")), ungraded),
                              expected};
    }
    return InputError{{}, QStringLiteral("a part was ended early; ") + ungraded, expected};
}

} // namespace

Result<GradeReport> mergeGrades(const QStringList &parts, const QString &results,
                                MergeExtent extent)
{
    auto read = readParts(parts, results);
    if (!read)
        return read.error();
    if (auto error = doubledIn(*read))
        return *error;
    GradeReport merged;
    merged.assignment = read->front().report.assignment;
    QSet<QString> graded;
    for (const MergedPart &each : *read) {
        for (const GradedSubmission &submission : each.report.submissions)
            graded += submission.name;
    }
    GradedPart whole;
    for (const MergedPart &each : *read)
        whole.submissions += each.part.submissions;
    for (const QString &name : graded)
        whole.submissions += name;
    whole.submissions.removeDuplicates();
    whole.submissions.sort();
    for (const QString &name : whole.submissions) {
        if (!graded.contains(name))
            merged.missing += name;
    }
    if (extent == MergeExtent::Whole) {
        if (auto error = incompleteness(*read, merged.missing))
            return *error;
    }
    const auto taken = beginResults(results, whole);
    if (!taken)
        return taken.error();
    const ResultsFolder folder(results);
    for (MergedPart &each : *read) {
        for (GradedSubmission &submission : each.report.submissions) {
            if (auto error = copySubmission(ResultsFolder(each.folder), folder, submission))
                return *error;
            merged.submissions.push_back(std::move(submission));
        }
    }
    std::ranges::sort(merged.submissions, {},
                      [](const GradedSubmission &each) { return std::pair(each.name, each.id); });
    if (auto error = folder.write(assignmentFile, writeAssignment(merged.assignment)))
        return *error;
    const bool hasReviews = std::ranges::any_of(
        merged.submissions, [](const GradedSubmission &each) { return !each.review.isEmpty(); });
    if (hasReviews) {
        if (auto error = writeReviews(results, merged))
            return *error;
    }
    if (auto error = writeReports(results, merged))
        return *error;
    return merged;
}

} // namespace pixelplumb
