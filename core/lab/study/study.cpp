// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/study.h"

#include "core/lab/study/studyplan.h"
#include "core/number/jobprogress.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

/// The progress of all parts of a study as one, each weighted by about how long it takes.
class StudyScale {
public:
    /// `whole`: s of all parts. The listener must outlive the scale.
    StudyScale(const ProgressListener &listener, double whole)
        : m_listener(listener)
        , m_whole(whole)
    {
    }

    /// The listener for the next part, which reports its own progress and takes about `seconds` s.
    ProgressListener next(double seconds)
    {
        const double before = m_before;
        m_before += seconds;
        return [this, before, seconds](const JobProgress &part) {
            const double share = part.total == 0 ? 0 : double(part.done) / double(part.total);
            return goesOn(m_listener, {part.phase, stepsOf(before + seconds * share), steps});
        };
    }

private:
    static constexpr std::int64_t steps = 100'000;

    std::int64_t stepsOf(double seconds) const
    {
        return std::min(steps, std::int64_t(double(steps) * seconds / m_whole));
    }

    const ProgressListener &m_listener;
    double m_whole;
    double m_before = 0;
};

namespace {

/// A path as one word of a shell command, and never an option.
QString quoted(const QString &path)
{
    static const QRegularExpression plain("^[A-Za-z0-9_@%+:,./-]+\\z");
    QString text = path;
    if (text.startsWith(u'-') && text.size() > 1)
        text.prepend(u"./"_s);
    if (plain.match(text).hasMatch())
        return text;
    return u'\'' + text.replace(u'\'', u"'\\''"_s) + u'\'';
}

/// Empty if the scene has no name to call it by.
QString commandFor(const StudySettings &settings)
{
    if (settings.ownScene && settings.ownSceneName.isEmpty())
        return {};
    QStringList words = {"pixelplumb-cli lab"};
    if (settings.ownScene)
        words << quoted(settings.ownSceneName);
    words << u"--"_s + nameOf(settings.extent) << u"--seed %1"_s.arg(settings.seed);
    if (!settings.families.isEmpty())
        words << u"--family "_s + settings.families.join(u',');
    QStringList ids;
    for (const LabContender &contender : settings.contenders)
        ids << contender.id;
    if (!ids.isEmpty())
        words << u"--contender "_s + ids.join(u',');
    return words.join(u' ');
}

bool drawsNothing(const AccuracyFigures &figures)
{
    return figures.missing + figures.tiesMissing == figures.pixels
        && figures.extra + figures.tiesExtra == 0;
}

class StudyRun {
public:
    StudyRun(const StudySettings &settings, const StudyListener &listener)
        : m_listener(listener)
        , m_plan(studyPlanFor(settings))
        , m_contenders(contendersFor(settings))
        , m_families(familiesFor(settings))
        , m_race(m_plan.race)
        , m_times(studyTimesFor(settings, m_plan))
        , m_scale(listener.progress, m_times.ofAll(m_families.size(), m_plan.rounds))
    {
        m_study.extent = settings.extent;
        m_study.seed = settings.seed;
        m_study.conditions = thisMachine();
        m_study.command = commandFor(settings);
        for (const LabContender &contender : m_contenders) {
            m_study.contenders.push_back({contender.id,
                                          contender.label,
                                          contender.kernel,
                                          contender.isProved(),
                                          contender.domain(),
                                          {}});
        }
        for (const LabFamily &family : m_families) {
            m_parts.push_back(timedPartOf(family, {}));
            m_study.families.push_back(m_parts.back().described);
            for (const LabContender &contender : m_contenders) {
                LabRow row;
                row.contender = contender.id;
                row.family = family.id;
                m_study.rows.push_back(std::move(row));
            }
        }
    }

    Study run()
    {
        m_study.isComplete = judgeAndStart() && finishRace() && addEffects();
        addFits();
        return m_study;
    }

private:
    void tellRow(std::size_t row) const
    {
        if (m_listener.rowChanged)
            m_listener.rowChanged(m_study, row);
    }

    /// Judges family by family, and times each once as soon as it is judged, so that results appear
    /// early.
    bool judgeAndStart()
    {
        m_expected.assign(m_study.rows.size(), 0);
        for (std::size_t index = 0; index < m_families.size(); ++index) {
            const auto tell = [&](std::size_t contender, const FamilyVerdict &verdict) {
                take(index, contender, verdict);
            };
            if (!judgeFamily(m_families[index], m_contenders, m_plan.accuracy, tell,
                             m_scale.next(m_times.judging)))
                return false;
            if (m_plan.rounds > 0 && !startRace(index))
                return false;
        }
        return true;
    }

    void take(std::size_t family, std::size_t contender, const FamilyVerdict &verdict)
    {
        const std::size_t index = family * m_contenders.size() + contender;
        LabRow &row = m_study.rows[index];
        row.outcome = verdict.outcome;
        row.remark = verdict.remark;
        row.settings = verdict.settings;
        row.accuracy = verdict.accuracy;
        row.firstMiss = verdict.firstMiss;
        if (verdict.operations)
            row.cost.emplace().operations = verdict.operations;
        if (verdict.accuracy && verdict.accuracy->pixels > 0)
            m_expected[index] = verdict.nanoseconds / double(verdict.accuracy->pixels)
                * double(m_study.families[family].timedPixels);
        tellRow(index);
    }

    /// Enters the contenders that were judged, and runs their first round.
    bool startRace(std::size_t family)
    {
        const std::size_t firstEntry = m_race.entries();
        const TimedFamily &part = m_parts[family];
        for (std::size_t who = 0; who < m_contenders.size() && part.isTimed(); ++who) {
            const std::size_t index = family * m_contenders.size() + who;
            LabRow &row = m_study.rows[index];
            if (row.outcome != LabOutcome::Measured)
                continue;
            if (drawsNothing(*row.accuracy)) {
                row.remark = "not timed: it draws none of these pixels";
                tellRow(index);
                continue;
            }
            if (m_race.enter(index, m_contenders[who], part, row.settings, expectedOf(index)))
                continue;
            row.remark
                = u"not timed: a draw takes about %1 ms"_s.arg(m_expected[index] / 1e6, 0, 'f', 0);
            tellRow(index);
        }
        const bool goesOnNow = m_race.runRound(0, m_scale.next(m_times.round), firstEntry);
        if (goesOnNow && family + 1 == m_families.size())
            m_study.rounds = 1;
        takeTimes();
        return goesOnNow;
    }

    /// ns of a timed draw; 0 for a contender that is timed in another way than it was judged.
    double expectedOf(std::size_t row) const
    {
        return m_contenders[row % m_contenders.size()].loaded ? 0 : m_expected[row];
    }

    bool finishRace()
    {
        const double seconds = m_times.round * double(m_families.size());
        for (int round = 1; round < m_plan.rounds; ++round) {
            const bool goesOnNow = m_race.runRound(round, m_scale.next(seconds));
            if (goesOnNow)
                m_study.rounds = round + 1;
            takeTimes();
            if (!goesOnNow)
                return false;
        }
        return true;
    }

    bool addEffects()
    {
        if (!m_plan.hasEffects)
            return true;
        auto effects = runEffectStudy(m_plan.rounds, m_scale.next(m_times.effects));
        if (!effects)
            return false;
        m_study.effects = std::move(*effects);
        return true;
    }

    void takeTimes()
    {
        for (const LabRace::Result &result : m_race.results()) {
            LabRow &row = m_study.rows[result.row];
            if (result.failure) {
                row.outcome = LabOutcome::Failed;
                row.remark = *result.failure;
            }
            if (result.cost.rounds > 0) {
                const auto operations
                    = row.cost ? row.cost->operations : std::optional<OperationCounts>();
                row.cost = result.cost;
                row.cost->operations = operations;
            }
        }
        if (m_listener.roundDone)
            m_listener.roundDone(m_study);
    }

    void addFits()
    {
        for (StudyContender &contender : m_study.contenders) {
            std::vector<CostPoint> points;
            for (const StudyFamily &family : m_study.families) {
                const LabRow *row = m_study.row(contender.id, family.id);
                if (!row || !row->cost || row->cost->rounds == 0)
                    continue;
                points.push_back({double(family.timedTriangles),
                                  double(family.timedSpans(contender.id)),
                                  double(family.timedPixels), row->cost->perDraw.median});
            }
            contender.fit = fitCost(points);
        }
    }

    const StudyListener &m_listener;
    StudyPlan m_plan;
    std::vector<LabContender> m_contenders;
    std::vector<LabFamily> m_families;
    std::vector<TimedFamily> m_parts; ///< by family
    std::vector<double> m_expected; ///< by row: ns that a draw of the timed part may take
    LabRace m_race;
    StudyTimes m_times;
    StudyScale m_scale;
    Study m_study;
};

} // namespace

Study runStudy(const StudySettings &settings, const StudyListener &listener)
{
    return StudyRun(settings, listener).run();
}

} // namespace pixelplumb
