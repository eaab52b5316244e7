// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/sharedgrading.h"

#include "core/grade/class/gradefile.h"
#include "core/number/failure.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFile>

#include <thread>
#include <utility>

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
        scene.picture = u"pictures/%1-%2.%3"_s.arg(submission.id, scene.scene,
                                                   picture.hasColours ? u"png"_s : u"txt"_s);
        const QByteArray copy = picture.hasColours ? pngOf(picture) : rasterOf(picture);
        scene.pictureDigest = pictureDigestOf(copy);
        if (auto error = results.write(scene.picture, copy))
            return error;
    }
    return results.write(submissionFile(submission.id),
                         writeGradedSubmission(submission, assignment));
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

} // namespace

SharedGrading::SharedGrading(const GradingOrder &order, const Assignment &assignment,
                             const ResultsLock &lock, const ProgressListener &listener)
    : m_order(order)
    , m_grader(assignment)
    , m_results(order.results)
    , m_lock(lock)
    , m_assignment(writeAssignment(assignment))
    , m_circumstances(circumstances(m_grader, m_assignment, order.version))
    , m_listener(listener)
{
}

std::vector<QByteArray> SharedGrading::run(std::vector<QByteArray> names)
{
    m_names = std::move(names);
    m_next = 0;
    m_total = m_done + std::int64_t(m_names.size());
    m_failed.reserve(m_names.size());
    m_claimedByOthers.reserve(m_names.size());
    tell(0);
    std::vector<std::jthread> threads;
    for (int i = 1; i < m_order.jobs; ++i)
        threads.emplace_back([this] { work(); });
    work();
    threads.clear();
    for (const QByteArray &name : std::exchange(m_failed, {})) {
        // The memory may have been taken by others.
        if (const Descriptor claim = claimOf(name); claim.isOpen())
            gradeAlone(name);
    }
    return std::exchange(m_claimedByOthers, {});
}

void SharedGrading::work()
{
    for (std::size_t i = m_next++; i < m_names.size(); i = m_next++) {
        const QByteArray &name = m_names[i];
        const Descriptor claim = claimOf(name);
        if (!claim.isOpen())
            continue;
        if (m_order.jobs == 1)
            gradeAlone(name);
        else if (failureOf([&] { endWith(gradeOne(name)); }))
            add(name, m_failed);
        tell(1);
    }
}

/// Not open where another run grades the submission, or where this one is stopped.
Descriptor SharedGrading::claimOf(const QByteArray &name)
{
    if (isStopped())
        return Descriptor();
    Result<Descriptor> claim = m_lock.claim(name);
    if (!claim) {
        endWith(claim.error());
        return Descriptor();
    }
    if (!claim->isOpen())
        add(name, m_claimedByOthers);
    return std::move(*claim);
}

void SharedGrading::add(const QByteArray &name, std::vector<QByteArray> &names)
{
    const std::lock_guard lock(m_mutex);
    names.push_back(name);
}

/// An error in grading belongs to this submission and does not affect the others' grades.
void SharedGrading::gradeAlone(const QByteArray &name)
{
    if (const auto failure = failureOf([&] { endWith(gradeOne(name)); })) {
        GradedWork work
            = m_grader.ungraded({QFile::encodeName(m_order.submissions), name}, *failure);
        endWith(write(m_results, work, m_assignment));
    }
}

/// Stops with the error, if there is one.
void SharedGrading::endWith(const std::optional<InputError> &error)
{
    if (!error)
        return;
    const std::lock_guard lock(m_mutex);
    if (!m_error)
        m_error = error;
    m_stop.request_stop();
}

std::optional<InputError> SharedGrading::gradeOne(const QByteArray &name)
{
    const SubmissionEntry entry(QFile::encodeName(m_order.submissions), name);
    QString digest;
    if (const auto bytes = entry.digest())
        digest = QString::fromLatin1(
            QCryptographicHash::hash(m_circumstances + *bytes, QCryptographicHash::Sha256).toHex());
    if (knownGrade(m_results, name, digest, m_assignment))
        return std::nullopt;
    std::optional<GradedWork> graded = m_grader.grade(entry, m_stop.get_token());
    if (!graded)
        return std::nullopt;
    graded->submission.digest = digest;
    return write(m_results, *graded, m_assignment);
}

void SharedGrading::tell(std::int64_t more)
{
    const std::lock_guard lock(m_mutex);
    m_done += more;
    if (!goesOn(m_listener, {JobPhase::Judging, m_done, m_total}))
        m_stop.request_stop();
}

} // namespace pixelplumb
