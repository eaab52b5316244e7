// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradereport.h"

#include "core/grade/try/sandbox.h"

#include <QMap>

#include <algorithm>

namespace pixelplumb {

namespace {

QString countText(std::int64_t count, const QString &what)
{
    return QStringLiteral("%1 %2").arg(pixelsText(count), what);
}

QString differencesText(const GradedScene &scene)
{
    QStringList parts;
    for (const Difference verdict : allDifferences) {
        const std::int64_t count = scene.counts.count(verdict);
        if (verdict != Difference::None && count > 0)
            parts += countText(count,
                               verdict == Difference::Colour ? QStringLiteral("of another colour")
                                                             : nameOf(verdict));
    }
    QString text = QStringLiteral("%1: %2").arg(scene.scene, parts.join(QStringLiteral(", ")));
    if (const auto &first = scene.firstDifference)
        text += QStringLiteral("; the first is (%1, %2)").arg(first->x).arg(first->y);
    return text;
}

void appendClass(const GradedSubmission &submission, QStringList &lines)
{
    const bool isRaster = submission.lacksColours();
    if (isRaster)
        lines += rasterText(submission);
    for (const GradedScene &scene : submission.scenes) {
        if (!scene.fault.isEmpty())
            lines += QStringLiteral("%1: %2").arg(scene.scene, scene.fault);
        QStringList failed;
        for (const GradedCheck &check : scene.checks) {
            if (!check.isPassed && !(isRaster && check.check == Check::Colours))
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
    if (submission.convention)
        lines += sentenceOf(*submission.convention);
    for (const GradedScene &scene : submission.scenes) {
        if (scene.note)
            lines += QStringLiteral("%1: %2").arg(scene.scene, *scene.note);
    }
}

void appendFull(const GradedSubmission &submission, QStringList &lines)
{
    if (submission.searchError)
        lines += QStringLiteral("the search for defects ended in an error: %1")
                     .arg(*submission.searchError);
    QStringList synonyms; // that draw the same pictures as the first
    for (const GradedCandidate &candidate : submission.candidates) {
        const bool isEqual = candidate.distance == 0 && !candidate.undecidable;
        if (isEqual && &candidate != &submission.candidates.front()) {
            synonyms += candidate.defects.join(QStringLiteral(" and "));
            continue;
        }
        // A set that explains next to nothing is not named.
        if (!isRelevant(candidate.distance, submission.differing))
            continue;
        const QString ids = candidate.defects.join(QStringLiteral(" and "));
        const QString open = undecidableText(candidate.undecidable.value_or(0));
        lines += candidate.distance == 0
            ? (QStringLiteral("explained by ") + ids
               + (open.isEmpty() ? QString() : QStringLiteral(", ") + open))
            : QStringLiteral("near to %1, %2")
                  .arg(ids, countText(candidate.distance, QStringLiteral("left")));
        lines += candidate.forAssistant;
        if (const auto &parts = candidate.parts)
            lines += QStringLiteral("%1 parts at step %2, %3: %4")
                         .arg(parts->scene)
                         .arg(parts->step + 1)
                         .arg(parts->heading, parts->text);
    }
    if (!synonyms.isEmpty())
        lines += QStringLiteral("the same pictures come of ") + synonyms.join(QStringLiteral("; "));
    if (const QString text = unsandboxedText(submission); !text.isEmpty())
        lines += text;
    for (const GradedScene &scene : submission.scenes) {
        if (scene.explanations)
            lines += QStringLiteral("%1 alone is explained by %2")
                         .arg(scene.scene, scene.explanations->join(QStringLiteral(", or ")));
        for (const QString &cause : scene.causes)
            lines += QStringLiteral("%1: most differences are gone with this done to the whole "
                                    "picture: %2")
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
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "right"));
    case GradeVerdict::Undecidable:
        return QStringLiteral("undecidable");
    case GradeVerdict::Wrong:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "wrong"));
    case GradeVerdict::Nothing:
        break;
    }
    return QStringLiteral(QT_TRANSLATE_NOOP("core", "nothing"));
}

QString nameOf(PictureLack lack)
{
    switch (lack) {
    case PictureLack::NotThere:
        return QStringLiteral("not there");
    case PictureLack::NotDrawn:
        return QStringLiteral("not drawn");
    case PictureLack::Empty:
        return QStringLiteral("empty");
    case PictureLack::OtherSize:
        return QStringLiteral("of another size");
    case PictureLack::TraceAlone:
        return QStringLiteral("a trace alone");
    case PictureLack::Unreadable:
        break;
    }
    return QStringLiteral("unreadable");
}

QStringList GradedCandidate::mistakes() const
{
    QStringList ids = defects;
    ids.removeIf([this](const QString &id) { return rightAlone && rightAlone->contains(id); });
    return ids.isEmpty() ? defects : ids;
}

double GradedSubmission::points() const { return review.points.value_or(pointsOfChecks()); }

double GradedSubmission::pointsOfChecks() const
{
    double sum = 0;
    for (const GradedScene &scene : scenes) {
        for (const GradedCheck &check : scene.checks)
            sum += check.points;
    }
    return sum;
}

bool GradedSubmission::lacksColours() const
{
    const auto isUnpassed = [](const GradedCheck &check) {
        return !check.isPassed && check.check != Check::Invariants;
    };
    return (verdict == GradeVerdict::Right || verdict == GradeVerdict::Undecidable)
        && std::ranges::any_of(scenes, [&](const GradedScene &scene) {
               return std::ranges::any_of(scene.checks, isUnpassed);
           });
}

QStringList GradedSubmission::lostInvariants() const
{
    QStringList lost;
    for (const GradedScene &scene : scenes) {
        const bool isLost = scene.fault.isEmpty()
            && std::ranges::any_of(scene.checks, [](const GradedCheck &check) {
                                return !check.isPassed && check.check == Check::Invariants;
                            });
        if (isLost && !scene.brokenInvariants)
            lost += QStringLiteral(QT_TRANSLATE_NOOP("core", "did not draw what invariants ask"));
        for (const QString &name :
             isLost ? scene.brokenInvariants.value_or(QStringList()) : QStringList())
            lost += QStringLiteral("breaks ") + name;
    }
    lost.removeDuplicates();
    return lost;
}

std::optional<bool> isSandboxed(const GradedSubmission &submission)
{
    std::optional<bool> isSandboxed;
    for (const GradedScene &scene : submission.scenes) {
        if (scene.run)
            isSandboxed = isSandboxed.value_or(true) && !scene.run->sandboxLack;
    }
    return isSandboxed;
}

QString unsandboxedText(const GradedSubmission &submission)
{
    for (const GradedScene &scene : submission.scenes) {
        if (scene.run && scene.run->sandboxLack)
            return QStringLiteral("its program ran in ") + unsandboxedText(*scene.run->sandboxLack);
    }
    return {};
}

QStringList sandboxLacks(const GradeReport &report)
{
    QStringList lacks;
    for (const GradedSubmission &submission : report.submissions) {
        for (const GradedScene &scene : submission.scenes) {
            if (scene.run && scene.run->sandboxLack)
                lacks += *scene.run->sandboxLack;
        }
    }
    lacks.removeDuplicates();
    return lacks;
}

QString unsandboxedText(const GradeReport &report)
{
    const auto count = std::ranges::count_if(report.submissions, [](const GradedSubmission &each) {
        return !isSandboxed(each).value_or(true);
    });
    const QStringList lacks = sandboxLacks(report);
    return lacks.isEmpty() ? QString()
                           : submissionsText(std::size_t(count)) + QStringLiteral(" ran in ")
            + unsandboxedText(lacks.join(QStringLiteral("; ")));
}

QString submissionsText(std::size_t submissions)
{
    return submissions == 1 ? QStringLiteral("1 submission")
                            : QStringLiteral("%1 submissions").arg(submissions);
}

QString ungradedText(const QString &error) { return QStringLiteral("cannot be graded: ") + error; }

QStringList ungradedLines(const GradeReport &report)
{
    QMap<QString, QStringList> names; // by error
    for (const GradedSubmission &each : report.submissions) {
        if (each.gradingError)
            names[*each.gradingError] += each.name;
    }
    QStringList lines;
    for (const auto &[error, those] : names.asKeyValueRange())
        lines += those.join(QStringLiteral(", ")) + QStringLiteral(": ") + ungradedText(error);
    return lines;
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
                lines += differencesText(scene);
        }
    }
    if (level >= HintLevel::Full)
        appendFull(submission, lines);
    if (submission.review.points)
        lines += QStringLiteral("%1 points in place of %2: %3")
                     .arg(*submission.review.points)
                     .arg(submission.pointsOfChecks())
                     .arg(submission.review.reason.value_or(QString()));
    if (!submission.review.comment.isEmpty())
        lines += submission.review.comment;
    return lines;
}

} // namespace pixelplumb
