// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"

#include "core/grade/class/gradefields.h"
#include "core/grade/class/resultsfolder.h"
#include "core/grade/class/seal.h"
#include "core/grade/class/submissionfolder.h"
#include "core/scene/fields/fieldreader.h"
#include "core/scene/fields/fieldwriter.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QSet>

#include <algorithm>

namespace pixelplumb {

namespace {

const QString gradesKey = u"pixelplumbGrades"_s;
const QString reviewsKey = u"reviews"_s;
const QString whatGradingWrote = u"what grading wrote; grade the submissions again"_s;

/// Whether it is one of our files; its version is checked before its keys.
bool expectFormat(JsonReader &json)
{
    if (!json.hasFailed())
        json.integer(json.root()[gradesKey], 1, gradesFormat);
    return !json.hasFailed();
}

/// Reads one of our files, edited or not.
template <class Part>
Result<Part> readOurs(const QByteArray &text)
{
    JsonReader json(text);
    Part part;
    if (expectFormat(json))
        FieldReader(json).readMembers(json.root(), part, {gradesKey, sealKey});
    return json.hasFailed() ? Result<Part>(json.error()) : Result<Part>(std::move(part));
}

/// Like readOurs(), but fails if the seal is broken.
template <class Part>
Result<Part> readSealed(const QByteArray &text, const QByteArray &about)
{
    Result<Part> part = readOurs<Part>(text);
    if (!part || isSealed(text, about))
        return part;
    return InputError{{},
                      u"has been edited since grading wrote it, or is of another "
                      "assignment or version"_s,
                      whatGradingWrote};
}

template <class Part>
QByteArray writeSealed(const Part &part, const QByteArray &about)
{
    QJsonObject object = jsonOf(part).toObject();
    object.insert(gradesKey, gradesFormat);
    return sealed(std::move(object), about);
}

/// What `read` returns, or its error with the file's name.
template <class Value, class Read>
Result<Value> readAt(const ResultsFolder &results, const QString &file, const Read &read)
{
    const Result<QByteArray> text = results.read(file);
    if (!text)
        return text.error();
    Result<Value> value = read(*text);
    return value ? value : Result<Value>(errorIn(results.pathOf(file), value.error()));
}

/// Those of the names that have no grade.
QStringList missingIn(const GradeReport &report, QStringList names)
{
    QSet<QString> graded;
    for (const GradedSubmission &each : report.submissions)
        graded += each.name;
    names.removeIf([&](const QString &name) { return graded.contains(name); });
    return names;
}

using Reviews = std::vector<std::pair<QString, GradeReview>>; // by id

Result<Reviews> readReviews(const QByteArray &text)
{
    JsonReader json(text);
    Reviews reviews;
    if (!expectFormat(json))
        return json.error();
    json.expectObject(json.root(), {gradesKey, reviewsKey});
    const JsonNode node = json.root()[reviewsKey];
    FieldReader reader(json);
    for (const QString &id : node.keys()) {
        GradeReview review;
        reader.read(node[id], review);
        reviews.emplace_back(id, review);
    }
    if (json.hasFailed())
        return json.error();
    return reviews;
}

/// Whether the names in a result's file are those that grading gives. A program without a sandbox
/// may have written the file, and must not make us read or write outside the results.
bool hasOwnNames(const GradedSubmission &submission, const QString &file)
{
    return file == submission.id + u".json"_s && submission.id == idOf(nameShownAs(submission.name))
        && std::ranges::all_of(submission.scenes, [](const GradedScene &scene) {
               return scene.picture.isEmpty()
                   || (scene.picture.startsWith(u"pictures/"_s) && scene.picture.count(u'/') == 1);
           });
}

} // namespace

QStringList resultFiles()
{
    return {assignmentFile, submissionListFile, reviewsFile,    u"results.json"_s,
            u"junit.xml"_s, u"grades.csv"_s,    u"index.html"_s};
}

QByteArray writeGradedSubmission(const GradedSubmission &submission, const QByteArray &assignment)
{
    return writeSealed(submission, assignment);
}

Result<GradedSubmission> readGradedSubmission(const QByteArray &text, const QByteArray &assignment)
{
    return readSealed<GradedSubmission>(text, assignment);
}

QString pictureDigestOf(const QByteArray &picture)
{
    return QString::fromLatin1(
        QCryptographicHash::hash(picture, QCryptographicHash::Sha256).toHex());
}

std::optional<InputError> changedPictureOf(const GradedSubmission &submission,
                                           const ResultsFolder &results)
{
    for (const GradedScene &scene : submission.scenes) {
        if (scene.picture.isEmpty())
            continue;
        const Result<QByteArray> picture = results.read(scene.picture);
        if (!picture)
            return picture.error();
        if (pictureDigestOf(*picture) != scene.pictureDigest)
            return InputError{results.pathOf(scene.picture),
                              u"has been changed since grading wrote it"_s, whatGradingWrote};
    }
    return std::nullopt;
}

QString assignmentFileOf(const QString &results)
{
    return ResultsFolder(results).pathOf(assignmentFile);
}

QString submissionFileOf(const QString &results, const QString &id)
{
    return ResultsFolder(results).pathOf(submissionFile(id));
}

QByteArray writeSubmissionList(const QStringList &names)
{
    return writeSealed(SubmissionList{names}, {});
}

std::optional<InputError> refusalOfResults(const ResultsFolder &folder)
{
    for (const QString &name : resultFiles()) {
        if (auto refusal = refusalToWrite(folder.pathOf(name)))
            return refusal;
    }
    const QStringList names = resultFiles() + ResultsFolder::folders();
    // A run that begins at the same time writes the list of submissions before all other files.
    const auto found = std::ranges::find_if(names, [&](const QString &name) {
        const bool isFolder = ResultsFolder::folders().contains(name);
        return isFolder ? !folder.filesIn(name).isEmpty() : folder.has(name);
    });
    if (found == names.end())
        return std::nullopt;
    if (!folder.has(submissionListFile))
        return InputError{folder.pathOf(*found), u"is not of results of grading"_s,
                          u"an empty folder, or one that grading wrote"_s};
    // An edited list is replaced as a whole.
    const auto known = readAt<SubmissionList>(folder, submissionListFile, readOurs<SubmissionList>);
    if (known)
        return std::nullopt;
    return InputError{known.error().place,
                      u"is not of results of grading: "_s + known.error().found,
                      known.error().expected};
}

Result<GradeReport> readGrades(const QString &results)
{
    const ResultsFolder folder(results);
    Result<Assignment> assignment
        = readAt<Assignment>(folder, assignmentFile, [&](const QByteArray &text) {
              return readAssignment(text, QFileInfo(results).absoluteFilePath());
          });
    if (!assignment)
        return assignment.error();
    GradeReport report{std::move(*assignment), {}, {}};
    const QByteArray asked = writeAssignment(report.assignment);
    for (const QString &file : folder.filesIn(u"grades"_s)) {
        if (!file.endsWith(u".json"_s))
            continue;
        const QString path = u"grades/"_s + file;
        const auto read = [&](const QByteArray &text) { return readGradedSubmission(text, asked); };
        auto submission = readAt<GradedSubmission>(folder, path, read);
        if (!submission)
            return submission.error();
        if (!hasOwnNames(*submission, file))
            return InputError{folder.pathOf(path), u"is not named as grading names it"_s,
                              u"the submission's name, the id that is made of it as "
                              "the file's name, and pictures in pictures/"_s};
        if (auto changed = changedPictureOf(*submission, folder))
            return *changed;
        report.submissions.push_back(std::move(*submission));
    }
    if (folder.has(submissionListFile)) {
        const auto list = readAt<SubmissionList>(folder, submissionListFile, [](const auto &text) {
            return readSealed<SubmissionList>(text, {});
        });
        if (!list)
            return list.error();
        report.missing = missingIn(report, list->submissions);
    }
    if (folder.has(reviewsFile)) {
        const auto reviews = readAt<Reviews>(folder, reviewsFile, readReviews);
        if (!reviews)
            return reviews.error();
        for (const auto &[id, review] : *reviews) {
            const auto found = std::ranges::find(report.submissions, id, &GradedSubmission::id);
            if (found != report.submissions.end())
                found->review = review;
        }
    }
    std::ranges::sort(report.submissions, {},
                      [](const GradedSubmission &each) { return std::pair(each.name, each.id); });
    return report;
}

std::optional<InputError> writeReviews(const QString &results, const GradeReport &report)
{
    QJsonObject reviews;
    // Reviews of submissions that are missing now, but may come back, are kept.
    const ResultsFolder folder(results);
    if (folder.has(reviewsFile)) {
        const auto written = readAt<Reviews>(folder, reviewsFile, readReviews);
        if (!written)
            return written.error();
        for (const auto &[id, review] : *written)
            reviews.insert(id, jsonOf(review));
    }
    for (const GradedSubmission &submission : report.submissions) {
        reviews.remove(submission.id);
        if (!submission.review.isEmpty())
            reviews.insert(submission.id, jsonOf(submission.review));
    }
    const QJsonObject object{{gradesKey, gradesFormat}, {reviewsKey, reviews}};
    return folder.write(reviewsFile, QJsonDocument(object).toJson());
}

} // namespace pixelplumb
