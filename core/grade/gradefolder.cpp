// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/gradefolder.h"

#include "core/grade/gradefile.h"
#include "core/grade/grader.h"
#include "core/grade/gradereports.h"
#include "core/grade/resultsfolder.h"
#include "core/number/failure.h"
#include "core/scene/fileaccess.h"
#include "core/scene/inputrecord.h"
#include "core/scene/outputfolder.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFile>
#include <QSet>

#include <algorithm>
#include <atomic>
#include <thread>

namespace pixelplumb {

namespace {

QByteArray pngOf(const Picture &picture)
{
    QByteArray png;
    QBuffer buffer(&png);
    imageOf(picture).save(&buffer, "png");
    return png;
}

QByteArray rasterOf(const Picture &picture)
{
    QByteArray raster;
    for (int line = 0; line < picture.height; ++line) {
        for (int x = 0; x < picture.width; ++x)
            raster += picture.covered[picture.placeOf(x, line)] != 0 ? '#' : '.';
        raster += '\n';
    }
    return raster;
}

/// Writes a graded submission: the pictures first, since the grade names them.
std::optional<InputError> write(const ResultsFolder &results, GradedWork &work,
                                const QByteArray &assignment)
{
    GradedSubmission &submission = work.submission;
    for (std::size_t i = 0; i < work.pictures.size(); ++i) {
        if (!work.pictures[i])
            continue;
        const Picture &picture = *work.pictures[i];
        GradedScene &scene = submission.scenes[i];
        scene.picture
            = QStringLiteral("pictures/%1-%2.%3")
                  .arg(submission.id, scene.scene,
                       picture.hasColours ? QStringLiteral("png") : QStringLiteral("txt"));
        const QByteArray copy = picture.hasColours ? pngOf(picture) : rasterOf(picture);
        scene.pictureDigest = pictureDigestOf(copy);
        if (auto error = results.write(scene.picture, copy))
            return error;
    }
    return results.write(submissionFile(submission.id),
                         writeGradedSubmission(submission, assignment));
}

bool isOfShard(const QByteArray &name, const GradeShard &shard)
{
    const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha256);
    return (uchar(hash[0]) * 256 + uchar(hash[1])) % shard.of == shard.number - 1;
}

/// What a grade depends on besides the submission.
QByteArray circumstances(const Grader &grader, const QByteArray &assignment, const QString &version)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(version.toUtf8() + '\n' + assignment);
    // Things that a scene refers to, such as a texture, may have changed.
    for (std::size_t i = 0; i < grader.assignment().scenes.size(); ++i)
        hash.addData(pngOf(grader.expected(i)));
    return hash.result();
}

/// The existing grade; none where it is missing, edited or of something else.
std::optional<GradedSubmission> knownGrade(const ResultsFolder &results, const QByteArray &name,
                                           const QString &digest, const QByteArray &assignment)
{
    const Result<QByteArray> text = results.read(submissionFile(idOf(name)));
    if (!text || digest.isEmpty())
        return std::nullopt;
    const Result<GradedSubmission> known = readGradedSubmission(*text, assignment);
    if (!known || known->digest != digest || known->searchError || known->id != idOf(name)
        || known->name != escapedName(name))
        return std::nullopt;
    return changedPictureOf(*known, results) ? std::nullopt : std::optional(*known);
}

/// Grades the listed submissions, several at once.
class FolderGrading {
public:
    FolderGrading(const GradingOrder &order, const Assignment &assignment,
                  std::vector<QByteArray> names, const ProgressListener &listener)
        : m_order(order)
        , m_grader(assignment)
        , m_results(order.results)
        , m_assignment(writeAssignment(assignment))
        , m_circumstances(circumstances(m_grader, m_assignment, order.version))
        , m_names(std::move(names))
        , m_listener(listener)
    {
    }

    /// False where it was ended, or could not write.
    bool run()
    {
        tell(0);
        m_failed.reserve(m_names.size());
        std::vector<std::jthread> threads;
        for (int i = 1; i < m_order.jobs; ++i)
            threads.emplace_back([this] { work(); });
        work();
        threads.clear();
        for (const std::size_t place : m_failed) { // the memory may have been taken by others
            if (!m_stop.stop_requested())
                gradeAlone(m_names[place]);
        }
        return !m_stop.stop_requested();
    }
    const std::optional<InputError> &error() const { return m_error; }

private:
    void work()
    {
        for (std::size_t i = m_next++; i < m_names.size(); i = m_next++) {
            if (m_stop.stop_requested())
                return;
            if (m_order.jobs == 1)
                gradeAlone(m_names[i]);
            else if (failureOf([&] { endWith(gradeOne(m_names[i])); }))
                putOff(i);
            tell(1);
        }
    }

    void putOff(std::size_t place)
    {
        const std::lock_guard lock(m_mutex);
        m_failed.push_back(place);
    }

    /// An error in grading belongs to this submission and does not affect the others' grades.
    void gradeAlone(const QByteArray &name)
    {
        if (const auto failure = failureOf([&] { endWith(gradeOne(name)); })) {
            GradedWork work
                = m_grader.ungraded({QFile::encodeName(m_order.submissions), name}, *failure);
            endWith(write(m_results, work, m_assignment));
        }
    }

    /// Stops with the error, if there is one.
    void endWith(const std::optional<InputError> &error)
    {
        if (!error)
            return;
        const std::lock_guard lock(m_mutex);
        if (!m_error)
            m_error = error;
        m_stop.request_stop();
    }

    std::optional<InputError> gradeOne(const QByteArray &name)
    {
        const SubmissionEntry entry(QFile::encodeName(m_order.submissions), name);
        QString digest;
        if (const auto bytes = entry.digest())
            digest = QString::fromLatin1(
                QCryptographicHash::hash(m_circumstances + *bytes, QCryptographicHash::Sha256)
                    .toHex());
        if (knownGrade(m_results, name, digest, m_assignment))
            return std::nullopt;
        std::optional<GradedWork> graded = m_grader.grade(entry, m_stop.get_token());
        if (!graded)
            return std::nullopt;
        graded->submission.digest = digest;
        return write(m_results, *graded, m_assignment);
    }

    void tell(std::int64_t more)
    {
        const std::lock_guard lock(m_mutex);
        m_done += more;
        if (!goesOn(m_listener, {JobPhase::Judging, m_done, std::int64_t(m_names.size())}))
            m_stop.request_stop();
    }

    const GradingOrder &m_order;
    Grader m_grader;
    ResultsFolder m_results;
    QByteArray m_assignment; ///< as written
    QByteArray m_circumstances;
    std::vector<QByteArray> m_names;
    const ProgressListener &m_listener;
    std::stop_source m_stop;
    std::atomic<std::size_t> m_next = 0;
    std::mutex m_mutex;
    std::int64_t m_done = 0;
    std::vector<std::size_t> m_failed; ///< indices of those that failed while others were graded
    std::optional<InputError> m_error;
};

/// Removes the results of submissions that no longer exist.
void removeOthers(const ResultsFolder &results, const Assignment &assignment,
                  const std::vector<QByteArray> &names)
{
    QSet<QString> kept;
    for (const QByteArray &name : names) {
        const QString id = idOf(name);
        kept += id + QStringLiteral(".json");
        for (const AssignedScene &scene : assignment.scenes) {
            for (const char *end : {"png", "txt"})
                kept += QStringLiteral("%1-%2.%3").arg(id, scene.name, QLatin1String(end));
        }
    }
    for (const QString &folder : ResultsFolder::folders()) {
        for (const QString &file : results.filesIn(folder)) {
            if (!kept.contains(file))
                results.remove(folder + u'/' + file);
        }
    }
}

/// Results inside the submissions, or the reverse, would be mixed up.
std::optional<InputError> refusalOf(const GradingOrder &order)
{
    if (!lieInEachOther(order.results, order.submissions))
        return std::nullopt;
    return InputError{order.results,
                      QStringLiteral("results and submissions lie in each other's folders"),
                      QStringLiteral("a folder of their own for the results")};
}

} // namespace

Result<std::optional<GradeReport>> gradeFolder(const GradingOrder &order,
                                               const Assignment &assignment,
                                               const ProgressListener &listener)
{
    Result<std::vector<QByteArray>> names = submissionsIn(order.submissions);
    if (!names)
        return names.error();
    GradedPart part{order.shard.number, order.shard.of, {}};
    for (const QByteArray &name : *names)
        part.submissions += escapedName(name);
    part.submissions.sort();
    std::erase_if(*names, [&](const QByteArray &name) { return !isOfShard(name, order.shard); });
    if (auto error = refusalOf(order))
        return *error;
    if (auto error = noteInputFolder(order.submissions))
        return *error;
    const ResultsFolder results(order.results);
    const auto taken = beginResults(order.results, part);
    if (!taken)
        return taken.error();
    if (auto error = results.write(assignmentFile, writeAssignment(assignment)))
        return *error;
    { // Frees what it knows of pictures before the reports.
        FolderGrading grading(order, assignment, *names, listener);
        const bool isDone = grading.run();
        if (grading.error())
            return *grading.error();
        if (!isDone)
            return std::optional<GradeReport>();
    }
    removeOthers(results, assignment, *names);
    Result<GradeReport> report = readGrades(order.results);
    if (!report)
        return report.error();
    if (auto error = writeReports(order.results, *report))
        return *error;
    return std::optional(std::move(*report));
}

} // namespace pixelplumb
