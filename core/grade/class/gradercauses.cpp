// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/delivery.h"
#include "core/grade/class/grader.h"
#include "core/grade/pictures/picturediff.h"
#include "core/number/failure.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"

#include <QCryptographicHash>

namespace pixelplumb {

namespace {

/// A hash of the pictures' bytes and of the scenes they belong to.
QByteArray keyOf(const std::vector<FoundPicture> &found)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    static_assert(sizeof(Colour) == 3);
    for (const FoundPicture &each : found) {
        const Picture &picture = each.picture;
        const auto size = qsizetype(picture.size());
        hash.addData(QByteArray::number(qulonglong(each.scene)) + (picture.hasColours ? "c" : "r"));
        const void *colours = picture.colours.data();
        const void *covered = picture.covered.data();
        hash.addData(QByteArrayView(static_cast<const char *>(colours), 3 * size));
        hash.addData(QByteArrayView(static_cast<const char *>(covered), size));
    }
    return hash.result();
}

} // namespace

GradedWork Grader::ungraded(const SubmissionEntry &entry, const QString &error) const
{
    GradedWork work;
    GradedSubmission &submission = work.submission;
    submission.name = escapedName(entry.name());
    submission.id = idOf(entry.name());
    submission.gradingError = error;
    Delivery nothing;
    nothing.fault = ungradedText(error);
    for (std::size_t scene = 0; scene < m_assignment.scenes.size(); ++scene)
        submission.scenes.push_back(judge(scene, nothing));
    work.pictures.resize(submission.scenes.size());
    return work;
}

std::optional<FirstDivergence> Grader::partingOf(const DiagnosisCandidate &candidate,
                                                 const std::vector<FoundPicture> &found) const
{
    for (const FoundPicture &each : found) {
        const auto own = ownDefects(m_pictures.defectsOf(each.scene), candidate.defects);
        if (const auto step = partingStepOf(m_pictures.scenes()[each.scene], own))
            return FirstDivergence{m_assignment.scenes[each.scene].name, std::int64_t(step->step),
                                   step->heading, step->text};
    }
    return std::nullopt;
}

std::optional<Diagnosis> Grader::diagnosisOf(std::span<const FoundPicture> found,
                                             const std::stop_token &stop)
{
    return diagnose(
        m_pictures, found, [&stop](const JobProgress &) { return !stop.stop_requested(); },
        m_assignment.margin);
}

GradedCandidate Grader::gradedOf(const DiagnosisCandidate &candidate,
                                 const std::vector<FoundPicture> &found) const
{
    GradedCandidate graded;
    graded.defects = candidate.ids();
    graded.forStudent = candidate.sentences(&Defect::forStudent);
    graded.forAssistant = candidate.sentences(&Defect::forAssistant);
    graded.distance = candidate.distance;
    if (candidate.undecidable > 0)
        graded.undecidable = candidate.undecidable;
    if (candidate.arithmetic)
        graded.arithmetic = nameText(nameOf(*candidate.arithmetic));
    graded.parts = partingOf(candidate, found);
    if (const QStringList ids = candidate.rightAlone(); !ids.isEmpty())
        graded.rightAlone = ids;
    return graded;
}

void Grader::tryOnAll(const DiagnosisCandidate &candidate, const std::vector<FoundPicture> &found,
                      const Diagnosis &whole, Named &named) const
{
    std::int64_t distance = 0;
    for (const FoundPicture &each : found) {
        Scene scene = m_pictures.scenes()[each.scene];
        scene.settings.arithmetic = candidate.arithmetic.value_or(scene.settings.arithmetic);
        std::vector<Defect> defects;
        for (const Defect &defect : candidate.defects) {
            const auto &known = m_pictures.defectsOf(each.scene);
            const auto own = std::ranges::find(known, defect.id, &Defect::id);
            // A convention that was read is no defect of any scene's.
            if (own != known.end() || defect.changeScene)
                defects.push_back(own != known.end() ? *own : defect);
        }
        if (!objectionTo(withDefects(scene, defects)).isEmpty())
            return;
        distance += differingPixels(pictureWith(scene, defects), each.picture);
    }
    const bool isNearer = named.candidates.empty() || distance < named.candidates.front().distance;
    if (!isNearer || !isRelevant(distance, whole.differing))
        return;
    DiagnosisCandidate nearer = candidate;
    nearer.distance = distance;
    nearer.undecidable = 0;
    named.candidates.insert(named.candidates.begin(), gradedOf(nearer, found));
}

std::optional<Grader::Named> Grader::named(const std::vector<FoundPicture> &found,
                                           const std::stop_token &stop)
{
    const QByteArray key = keyOf(found);
    {
        const std::lock_guard lock(m_mutex);
        if (const auto known = m_known.find(key); known != m_known.end())
            return known->second;
    }
    Named named;
    named.pictures = QString::fromLatin1(key.toHex().left(16));
    bool isDone = true;
    if (auto failure = failureOf([&] { isDone = search(found, stop, named); }))
        named.error = std::move(failure);
    if (!isDone)
        return std::nullopt;
    if (named.error)
        return Named{named.pictures, {}, {}, named.error}; // not kept: the next attempt may succeed
    const std::lock_guard lock(m_mutex);
    m_known.emplace(key, named);
    return named;
}

bool Grader::search(const std::vector<FoundPicture> &found, const std::stop_token &stop,
                    Named &named)
{
    const auto whole = diagnosisOf(found, stop);
    if (!whole)
        return false;
    named.error = whole->failure;
    for (const DiagnosisCandidate &candidate : whole->candidates)
        named.candidates.push_back(gradedOf(candidate, found));
    if (whole->isExplained() || whole->verdict != DiagnosisVerdict::Wrong)
        return true;
    const auto others = setsOfOtherMethods(
        m_pictures, found, [&stop](const JobProgress &) { return !stop.stop_requested(); },
        m_assignment.margin);
    if (!others)
        return false;
    if (!others->empty())
        named.candidates.clear();
    for (const DiagnosisCandidate &candidate : *others)
        named.candidates.push_back(gradedOf(candidate, found));
    if (!others->empty() || found.size() == 1)
        return true;
    for (const FoundPicture &each : found) {
        const auto part = diagnosisOf(std::span(&each, 1), stop);
        if (!part)
            return false;
        if (part->failure)
            named.error = part->failure;
        if (!part->isExplained())
            continue;
        for (const DiagnosisCandidate &candidate : part->candidates)
            named.explanations[each.scene] += candidate.ids().join(u" and "_s);
        tryOnAll(part->candidates.front(), found, *whole, named);
    }
    return true;
}

} // namespace pixelplumb
