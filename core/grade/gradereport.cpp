// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/gradereport.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QString setsText(const std::vector<GradedCandidate> &candidates)
{
    QStringList sets;
    for (const GradedCandidate &candidate : candidates)
        sets += candidate.defects.join(QStringLiteral(" and "));
    return sets.join(QStringLiteral(", or "));
}

/// Of a submission that has a picture too few: what became of it; empty of others.
QString faultTitle(const GradedSubmission &submission)
{
    const auto count = [&submission](const auto &isSuch) {
        return std::ranges::count_if(submission.scenes, isSuch);
    };
    const auto faulty = count([](const GradedScene &scene) { return !scene.fault.isEmpty(); });
    const auto inFiles = count(
        [](const GradedScene &scene) { return !scene.fault.isEmpty() && !scene.file.isEmpty(); });
    if (faulty > 0 && inFiles == faulty)
        return QStringLiteral("pictures of another size, or unreadable");
    if (submission.verdict == GradeVerdict::Nothing)
        return QStringLiteral("no picture");
    return faulty > 0 ? QStringLiteral("pictures are missing") : QString();
}

QString clusterTitle(const GradedSubmission &submission)
{
    if (submission.verdict == GradeVerdict::Nothing)
        return faultTitle(submission);
    if (submission.verdict == GradeVerdict::Right)
        return QStringLiteral("right");
    if (submission.isExplained())
        return setsText(submission.candidates);
    if (submission.verdict == GradeVerdict::Undecidable)
        return QStringLiteral("undecidable");
    const QString fault = faultTitle(submission);
    return submission.differing == 0 && !fault.isEmpty() ? fault
                                                         : QStringLiteral("no known defect");
}

QString countText(std::int64_t count, const QString &what)
{
    return QStringLiteral("%1 %2 %3")
        .arg(count)
        .arg(count == 1 ? QStringLiteral("pixel") : QStringLiteral("pixels"), what);
}

QString pixelsText(const GradedScene &scene)
{
    QStringList parts;
    for (const PixelVerdict verdict : allPixelVerdicts) {
        const std::int64_t count = scene.counts[std::size_t(verdict)];
        if (verdict != PixelVerdict::Same && count > 0)
            parts += countText(count,
                               verdict == PixelVerdict::Colour ? QStringLiteral("of another colour")
                                                               : nameOf(verdict));
    }
    QString text = QStringLiteral("%1: %2").arg(scene.scene, parts.join(QStringLiteral(", ")));
    if (const auto &first = scene.firstDifference)
        text += QStringLiteral("; the first is (%1, %2)").arg(first->x).arg(first->y);
    return text;
}

void appendClass(const GradedSubmission &submission, QStringList &lines)
{
    for (const GradedScene &scene : submission.scenes) {
        if (!scene.fault.isEmpty())
            lines += QStringLiteral("%1: %2").arg(scene.scene, scene.fault);
        QStringList failed;
        for (const GradedCheck &check : scene.checks) {
            if (!check.isPassed)
                failed += nameOf(check.check);
        }
        if (scene.fault.isEmpty() && !failed.isEmpty())
            lines += QStringLiteral("%1: not right in %2")
                         .arg(scene.scene, failed.join(QStringLiteral(" and ")));
    }
    if (lines.isEmpty() && submission.verdict == GradeVerdict::Undecidable)
        lines += QStringLiteral("right; what differs may be either way");
    else if (lines.isEmpty())
        lines += nameOf(submission.verdict);
}

void appendNotes(const GradedSubmission &submission, QStringList &lines)
{
    for (const GradedScene &scene : submission.scenes) {
        if (scene.note)
            lines += QStringLiteral("%1: %2").arg(scene.scene, *scene.note);
    }
}

void appendFull(const GradedSubmission &submission, QStringList &lines)
{
    for (const GradedCandidate &candidate : submission.candidates) {
        const QString ids = candidate.defects.join(QStringLiteral(" and "));
        lines += candidate.distance == 0
            ? QStringLiteral("explained by %1").arg(ids)
            : QStringLiteral("near to %1, %2")
                  .arg(ids, countText(candidate.distance, QStringLiteral("left")));
        lines += candidate.forAssistant;
        if (const auto &parts = candidate.parts)
            lines += QStringLiteral("%1 parts at step %2, %3: %4")
                         .arg(parts->scene)
                         .arg(parts->step + 1)
                         .arg(parts->heading, parts->text);
    }
    for (const GradedScene &scene : submission.scenes) {
        for (const QString &cause : scene.causes)
            lines += QStringLiteral("%1: most differences are gone where it is %2")
                         .arg(scene.scene, cause);
        if (scene.run && !scene.run->messages.isEmpty())
            lines += QStringLiteral("%1: the program said: %2")
                         .arg(scene.scene, scene.run->messages.trimmed());
    }
}

} // namespace

QString nameOf(GradeVerdict verdict)
{
    switch (verdict) {
    case GradeVerdict::Right:
        return QStringLiteral("right");
    case GradeVerdict::Undecidable:
        return QStringLiteral("undecidable");
    case GradeVerdict::Wrong:
        return QStringLiteral("wrong");
    case GradeVerdict::Nothing:
        break;
    }
    return QStringLiteral("nothing");
}

double GradedSubmission::points() const
{
    double sum = 0;
    for (const GradedScene &scene : scenes) {
        for (const GradedCheck &check : scene.checks)
            sum += check.points;
    }
    return sum;
}

std::vector<GradeCluster> clustersOf(const GradeReport &report)
{
    std::vector<GradeCluster> clusters;
    for (std::size_t i = 0; i < report.submissions.size(); ++i) {
        const GradedSubmission &submission = report.submissions[i];
        const QString title = clusterTitle(submission);
        auto cluster = std::ranges::find(clusters, title, &GradeCluster::title);
        if (cluster == clusters.end()) {
            clusters.push_back({title, {}, {}, {}});
            cluster = std::prev(clusters.end());
            if (submission.isExplained()) {
                cluster->forStudent = submission.candidates.front().forStudent;
                cluster->forAssistant = submission.candidates.front().forAssistant;
            }
        }
        cluster->submissions.push_back(i);
    }
    const auto order = [](const GradeCluster &cluster) {
        return std::tuple(cluster.title == nameOf(GradeVerdict::Right),
                          -std::int64_t(cluster.submissions.size()), cluster.title);
    };
    std::ranges::sort(clusters, {}, order);
    return clusters;
}

QStringList sentencesFor(const GradedSubmission &submission, HintLevel level)
{
    QStringList lines;
    appendClass(submission, lines);
    appendNotes(submission, lines);
    const bool isWrong = submission.verdict == GradeVerdict::Wrong;
    const GradedCandidate *cause
        = isWrong && submission.isExplained() ? &submission.candidates.front() : nullptr;
    if (level >= HintLevel::Hint && cause)
        lines += cause->forStudent;
    if (level >= HintLevel::Pixels) {
        for (const GradedScene &scene : submission.scenes) {
            if (!scene.trace.isEmpty())
                lines += QStringLiteral("%1: %2").arg(scene.scene, scene.trace);
            if (scene.firstDifference)
                lines += pixelsText(scene);
        }
    }
    if (level >= HintLevel::Full)
        appendFull(submission, lines);
    if (!submission.review.comment.isEmpty())
        lines += submission.review.comment;
    return lines;
}

} // namespace pixelplumb
