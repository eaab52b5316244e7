// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradereport.h"
#include "core/grade/try/programrun.h"

#include <QMap>

#include <algorithm>

namespace pixelplumb {

namespace {

/// Names only mistakes: a defect that alone is none names no cause.
QString setText(const GradedCandidate &candidate) { return candidate.mistakes().join(u" and "_s); }

/// All sets that explain the submission.
QStringList setsOf(const GradedSubmission &submission)
{
    QStringList sets;
    for (const GradedCandidate &candidate : submission.candidates)
        sets += setText(candidate);
    sets.removeDuplicates();
    return sets;
}

/// "crashed", "timed out", "empty": why a scene has no picture; empty where there is one, or where
/// the grade predates these reasons.
QString lackText(const GradedScene &scene)
{
    if (!scene.lack)
        return {};
    const bool hasEnded = scene.run && scene.run->end != nameOf(ProgramEnd::Finished);
    return *scene.lack == PictureLack::NotDrawn && hasEnded ? scene.run->end : nameOf(*scene.lack);
}

/// The title of a submission that lacks a picture: why, each reason once; empty for others.
QString faultTitle(const GradedSubmission &submission)
{
    QStringList lacks;
    bool isFaulty = false;
    for (const GradedScene &scene : submission.scenes) {
        isFaulty = isFaulty || !scene.fault.isEmpty();
        if (const QString lack = lackText(scene); !lack.isEmpty())
            lacks += lack;
    }
    lacks.sort();
    lacks.removeDuplicates();
    const bool hasNone = submission.verdict == GradeVerdict::Nothing;
    if (!hasNone && !isFaulty)
        return {};
    const QString what = hasNone ? u"no picture"_s : u"not every scene has a picture"_s;
    return lacks.isEmpty() ? what : what + u": "_s + lacks.join(u", "_s);
}

/// What is known about a class before its submissions are grouped.
class ClusterTitles {
public:
    explicit ClusterTitles(const GradeReport &report)
    {
        for (const GradedSubmission &each : report.submissions) {
            if (each.isExplained())
                takeSets(each);
            if (each.pictures)
                m_alike[*each.pictures] += each.name;
        }
    }

    QString titleOf(const GradedSubmission &submission) const
    {
        if (submission.gradingError)
            return ungradedText(*submission.gradingError);
        if (submission.verdict == GradeVerdict::Nothing)
            return faultTitle(submission);
        if (!submission.lostInvariants().isEmpty() && submission.verdict != GradeVerdict::Wrong)
            return verdictText(submission);
        if (submission.verdict == GradeVerdict::Right)
            return submission.lacksColours() ? rasterText(submission) : verdictText(submission);
        const QString sets = submission.isExplained()
            ? m_sets[setText(submission.candidates.front())].join(u", or "_s)
            : QString();
        if (submission.verdict == GradeVerdict::Undecidable)
            return openTitle(submission, sets);
        if (!sets.isEmpty())
            return sets;
        const QString fault = faultTitle(submission);
        if (submission.differing == 0 && !fault.isEmpty())
            return fault;
        if (submission.searchError)
            return u"the search for defects ended in an error"_s;
        return u"no known defect"_s + likenessOf(submission);
    }

private:
    /// Nothing is wrong with it, whatever explains it, so it is kept apart from submissions with
    /// mistakes.
    static QString openTitle(const GradedSubmission &submission, const QString &sets)
    {
        const QString title = submission.lacksColours() ? rasterText(submission) : u"full points"_s;
        return title + u": a right program may draw this"_s
            + (sets.isEmpty() ? QString() : u", as may one with "_s + sets);
    }

    /// Among submissions with the same first set, keeps the sets that explain them all: rounding
    /// may give one of them more sets than another.
    void takeSets(const GradedSubmission &submission)
    {
        const QStringList sets = setsOf(submission);
        const auto known = m_sets.find(sets.front());
        if (known == m_sets.end())
            m_sets.insert(sets.front(), sets);
        else
            known->removeIf([&sets](const QString &set) { return !sets.contains(set); });
    }

    QString likenessOf(const GradedSubmission &submission) const
    {
        const QStringList alike
            = submission.pictures ? m_alike[*submission.pictures] : QStringList();
        if (alike.size() > 1)
            return u", the same pictures as %1"_s.arg(alike.front());
        const bool isNear = !submission.candidates.empty()
            && isRelevant(submission.candidates.front().distance, submission.differing);
        return isNear ? u", close to %1"_s.arg(setText(submission.candidates.front())) : QString();
    }

    QMap<QString, QStringList> m_sets; ///< by the first set
    QMap<QString, QStringList> m_alike; ///< names, by set of pictures
};

} // namespace

QString verdictText(const GradedSubmission &submission)
{
    if (submission.gradingError)
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "cannot be graded"));
    const QString name = nameOf(submission.verdict);
    const QString lost = submission.lostInvariants();
    const bool isOfPictures = submission.verdict != GradeVerdict::Wrong && !lost.isEmpty()
        && !submission.lacksColours();
    const QString told = submission.lacksColours() ? name + u" in coverage"_s
        : isOfPictures                             ? u"pictures "_s + name
                                                   : name;
    return lost.isEmpty() ? told : u"%1, %2"_s.arg(told, lost);
}

QString rasterText(const GradedSubmission &submission)
{
    return u"%1 in coverage (a raster has no colours)"_s.arg(nameOf(submission.verdict));
}

std::vector<GradeCluster> clustersOf(const GradeReport &report)
{
    const ClusterTitles titles(report);
    std::vector<GradeCluster> clusters;
    for (std::size_t i = 0; i < report.submissions.size(); ++i) {
        const GradedSubmission &submission = report.submissions[i];
        const QString title = titles.titleOf(submission);
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

} // namespace pixelplumb
