// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradereport.h"

#include "core/grade/try/sandbox.h"

#include <QMap>

#include <algorithm>

namespace pixelplumb {

namespace {

QString countText(std::int64_t count, const QString &what)
{
    return u"%1 %2"_s.arg(pixelsText(count), what);
}

QString differencesText(const GradedScene &scene)
{
    QStringList parts;
    for (const Difference verdict : allDifferences) {
        const std::int64_t count = scene.counts.count(verdict);
        if (verdict != Difference::None && count > 0)
            parts += countText(
                count, verdict == Difference::Colour ? u"of another colour"_s : nameOf(verdict));
    }
    QString text = u"%1: %2"_s.arg(scene.scene, parts.join(u", "_s));
    if (const auto &first = scene.firstDifference)
        text += u"; the first is (%1, %2)"_s.arg(first->x).arg(first->y);
    return text;
}

void appendClass(const GradedSubmission &submission, QStringList &lines)
{
    const bool isRaster = submission.lacksColours();
    if (isRaster)
        lines += rasterText(submission);
    for (const GradedScene &scene : submission.scenes) {
        if (!scene.fault.isEmpty())
            lines += u"%1: %2"_s.arg(scene.scene, scene.fault);
        QStringList failed;
        for (const GradedCheck &check : scene.checks) {
            if (!check.isPassed && !(isRaster && check.check == Check::Colours))
                failed += nameOf(check.check);
        }
        if (scene.fault.isEmpty() && !failed.isEmpty())
            lines += u"%1: not right in %2"_s.arg(scene.scene, failed.join(u" and "_s));
    }
    if (lines.isEmpty() && submission.verdict == GradeVerdict::Undecidable)
        lines += u"right within the leeway: a right program may draw this"_s;
    else if (lines.isEmpty())
        lines += nameOf(submission.verdict);
}

void appendNotes(const GradedSubmission &submission, QStringList &lines)
{
    if (submission.convention)
        lines += sentenceOf(*submission.convention) + u"; judged by that convention"_s;
    for (const GradedScene &scene : submission.scenes) {
        if (scene.note)
            lines += u"%1: %2"_s.arg(scene.scene, *scene.note);
    }
}

/// "a, or b, or 3 others"
QString firstOf(const QStringList &sets)
{
    constexpr qsizetype mostTold = 5;
    const qsizetype others = sets.size() - mostTold;
    QStringList told = sets.first(std::min(sets.size(), mostTold));
    if (others > 0)
        told += others == 1 ? u"another"_s : u"%1 others"_s.arg(others);
    return told.join(u", or "_s);
}

void appendCandidates(const GradedSubmission &submission, QStringList &lines)
{
    QStringList synonyms; // that draw the same pictures as the first
    for (const GradedCandidate &candidate : submission.candidates) {
        const bool isEqual = candidate.distance == 0 && !candidate.undecidable;
        if (isEqual && &candidate != &submission.candidates.front()) {
            synonyms += candidate.defects.join(u" and "_s);
            continue;
        }
        // A set that explains next to nothing is not named.
        if (!isRelevant(candidate.distance, submission.differing))
            continue;
        const QString ids = candidate.defects.join(u" and "_s);
        const QString open = undecidableText(candidate.undecidable.value_or(0));
        lines += candidate.distance == 0
            ? (u"explained by "_s + ids + (open.isEmpty() ? QString() : u", "_s + open))
            : u"close to %1, %2"_s.arg(ids, countText(candidate.distance, u"left"_s));
        lines += candidate.forAssistant;
        if (const auto &parts = candidate.parts)
            lines += u"%1 parts at step %2, %3: %4"_s.arg(parts->scene)
                         .arg(parts->step + 1)
                         .arg(parts->heading, parts->text);
    }
    if (!synonyms.isEmpty())
        lines += u"the same pictures also come from "_s + synonyms.join(u"; "_s);
}

void appendFull(const GradedSubmission &submission, QStringList &lines)
{
    if (submission.searchError)
        lines += u"the search for defects ended in an error: %1"_s.arg(*submission.searchError);
    if (submission.verdict == GradeVerdict::Wrong) // a right program may draw the rest
        appendCandidates(submission, lines);
    if (const QString text = unsandboxedText(submission); !text.isEmpty())
        lines += text;
    for (const GradedScene &scene : submission.scenes) {
        if (scene.explanations)
            lines += u"%1 taken alone is explained by %2"_s.arg(scene.scene,
                                                                firstOf(*scene.explanations));
        for (const QString &place :
             submission.isExplained() ? QStringList() : scene.places.value_or(QStringList()))
            lines += u"%1: %2"_s.arg(scene.scene, place);
        for (const QString &cause : scene.causes)
            lines += u"%1: most differences vanish if this is done to the whole picture: %2"_s.arg(
                scene.scene, cause);
        if (scene.run && !scene.run->messages.isEmpty())
            lines += u"%1: the program said: %2"_s.arg(scene.scene, scene.run->messages.trimmed());
    }
}

} // namespace

QString nameOf(GradeVerdict verdict)
{
    switch (verdict) {
    case GradeVerdict::Right:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "right"));
    case GradeVerdict::Undecidable:
        return u"undecidable"_s;
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
        return u"not there"_s;
    case PictureLack::NotDrawn:
        return u"not drawn"_s;
    case PictureLack::Empty:
        return u"empty"_s;
    case PictureLack::OtherSize:
        return u"of another size"_s;
    case PictureLack::TraceAlone:
        return u"a trace alone"_s;
    case PictureLack::Unreadable:
        break;
    }
    return u"unreadable"_s;
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

QString GradedSubmission::lostInvariants() const
{
    QStringList lost;
    for (const GradedScene &scene : scenes) {
        const bool isLost = scene.fault.isEmpty()
            && std::ranges::any_of(scene.checks, [](const GradedCheck &check) {
                                return !check.isPassed && check.check == Check::Invariants;
                            });
        if (isLost && !scene.brokenInvariants)
            lost += QStringLiteral(QT_TRANSLATE_NOOP("core", "did not draw what invariants ask"));
        for (const QString &broken :
             isLost ? scene.brokenInvariants.value_or(QStringList()) : QStringList())
            lost += u"breaks "_s + broken;
    }
    lost.removeDuplicates();
    return lost.join(u", "_s);
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
            return u"its program ran in "_s + unsandboxedText(*scene.run->sandboxLack);
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
                           : submissionsText(std::size_t(count)) + u" ran in "_s
            + unsandboxedText(lacks.join(u"; "_s));
}

QString submissionsText(std::size_t submissions)
{
    return submissions == 1 ? u"1 submission"_s : u"%1 submissions"_s.arg(submissions);
}

QString ungradedText(const QString &error) { return u"cannot be graded: "_s + error; }

QStringList ungradedLines(const GradeReport &report)
{
    QMap<QString, QStringList> names; // by error
    for (const GradedSubmission &each : report.submissions) {
        if (each.gradingError)
            names[*each.gradingError] += each.name;
    }
    QStringList lines;
    for (const auto &[error, those] : names.asKeyValueRange())
        lines += those.join(u", "_s) + u": "_s + ungradedText(error);
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
                lines += u"%1: %2"_s.arg(scene.scene, scene.trace);
            if (scene.firstDifference)
                lines += differencesText(scene);
        }
    }
    if (level >= HintLevel::Full)
        appendFull(submission, lines);
    if (submission.review.points)
        lines += u"%1 points instead of %2: %3"_s.arg(*submission.review.points)
                     .arg(submission.pointsOfChecks())
                     .arg(submission.review.reason.value_or(QString()));
    if (!submission.review.comment.isEmpty())
        lines += submission.review.comment;
    return lines;
}

} // namespace pixelplumb
