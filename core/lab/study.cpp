// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study.h"

#include "core/lab/familyaccuracy.h"
#include "core/lab/labrace.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

/// What an extent comes to.
struct Plan {
    AccuracyOptions accuracy;
    RaceOptions race;
    int rounds = 5;
};

Plan planFor(const StudySettings &settings)
{
    Plan plan;
    if (settings.extent == StudyExtent::Full) {
        plan.accuracy = {600'000'000, 60, 200'000, 1'000'000, 40'000};
        plan.race.longestDraw = 60e6;
        plan.rounds = 7;
    }
    if (settings.mostSamples > 0)
        plan.accuracy.mostSamples = settings.mostSamples;
    if (settings.hangSeconds > 0)
        plan.accuracy.hangSeconds = settings.hangSeconds;
    if (settings.rounds >= 0)
        plan.rounds = settings.rounds;
    return plan;
}

/// A path as one word of a shell's line, and never an option.
QString quoted(const QString &path)
{
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+:,./-]+\\z"));
    QString text = path;
    if (text.startsWith(u'-') && text.size() > 1)
        text.prepend(QStringLiteral("./"));
    if (plain.match(text).hasMatch())
        return text;
    return u'\'' + text.replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

/// Empty where the scene has no name to call it by.
QString commandFor(const StudySettings &settings)
{
    if (settings.ownScene && settings.ownSceneName.isEmpty())
        return {};
    QStringList words = {QStringLiteral("pixelplumb-cli lab")};
    if (settings.ownScene)
        words << quoted(settings.ownSceneName);
    words << QStringLiteral("--") + nameOf(settings.extent)
          << QStringLiteral("--seed %1").arg(settings.seed);
    if (!settings.families.isEmpty())
        words << QStringLiteral("--family ") + settings.families.join(u',');
    QStringList ids;
    for (const LabContender &contender : settings.contenders)
        ids << contender.id;
    if (!ids.isEmpty())
        words << QStringLiteral("--contender ") + ids.join(u',');
    return words.join(u' ');
}

class StudyRun {
public:
    StudyRun(const StudySettings &settings, const StudyListener &listener)
        : m_settings(settings)
        , m_listener(listener)
        , m_plan(planFor(settings))
    {
        m_contenders = settings.contenders;
        if (m_contenders.empty())
            m_contenders
                = settings.extent == StudyExtent::Quick ? quickContenders() : fullContenders();
    }

    Study run()
    {
        begin();
        m_study.isComplete = judge() && race();
        addFits();
        return m_study;
    }

private:
    void begin()
    {
        m_study.extent = m_settings.extent;
        m_study.seed = m_settings.seed;
        m_study.conditions = thisMachine();
        m_study.command = commandFor(m_settings);
        for (const LabContender &contender : m_contenders) {
            m_study.contenders.push_back(
                {contender.id, contender.label, contender.isProved(), contender.domain(), {}});
        }
        const FamilyRequest request{m_settings.seed, m_settings.extent, m_settings.ownScene,
                                    m_settings.hardCases};
        for (const LabFamilyInfo &info : labFamilies()) {
            if (!m_settings.families.isEmpty()
                && !m_settings.families.contains(QLatin1String(info.id)))
                continue;
            if (auto family = makeFamily(info, request))
                m_families.push_back(std::move(*family));
        }
        for (const LabFamily &family : m_families) {
            m_parts.push_back(timedPartOf(family, m_plan.race));
            m_study.families.push_back(m_parts.back().described);
            for (const LabContender &contender : m_contenders) {
                LabRow row;
                row.contender = contender.id;
                row.family = family.id;
                m_study.rows.push_back(std::move(row));
            }
        }
    }

    void tellRow(std::size_t row) const
    {
        if (m_listener.rowChanged)
            m_listener.rowChanged(m_study, row);
    }

    bool judge()
    {
        constexpr std::int64_t share = 1000; // of progress, a family
        m_expected.assign(m_study.rows.size(), 0);
        for (std::size_t index = 0; index < m_families.size(); ++index) {
            const LabFamily &family = m_families[index];
            const auto hear = [&](const JobProgress &progress) {
                const std::int64_t within
                    = progress.total == 0 ? 0 : share * progress.done / progress.total;
                return goesOn(m_listener.progress,
                              {progress.phase, std::int64_t(index) * share + within,
                               std::int64_t(m_families.size()) * share});
            };
            const auto tell = [&](std::size_t contender, const FamilyVerdict &verdict) {
                take(index, contender, verdict);
            };
            if (!judgeFamily(family, m_contenders, m_plan.accuracy, tell, hear))
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
        if (verdict.accuracy && verdict.accuracy->triangles > 0)
            m_expected[index] = verdict.nanoseconds / double(verdict.accuracy->triangles)
                * double(m_parts[family].triangles);
        tellRow(index);
    }

    bool race()
    {
        if (m_plan.rounds == 0)
            return true;
        LabRace laps(m_plan.race);
        for (std::size_t index = 0; index < m_study.rows.size(); ++index) {
            LabRow &row = m_study.rows[index];
            const TimedFamily &part = m_parts[index / m_contenders.size()];
            if (row.outcome != LabOutcome::Measured || !part.isTimed())
                continue;
            if (!laps.enter(index, m_contenders[index % m_contenders.size()], part, row.settings,
                            m_expected[index])) {
                row.remark = QStringLiteral("not timed: a draw takes about %1 ms")
                                 .arg(m_expected[index] / 1e6, 0, 'f', 0);
                tellRow(index);
            }
        }
        for (int round = 0; round < m_plan.rounds; ++round) {
            const bool goesOnNow = laps.runRound(round, m_plan.rounds, m_listener.progress);
            if (goesOnNow)
                m_study.rounds = round + 1;
            takeTimes(laps);
            if (!goesOnNow)
                return false;
        }
        return true;
    }

    void takeTimes(const LabRace &laps)
    {
        for (const LabRace::Result &result : laps.results()) {
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

    const StudySettings &m_settings;
    const StudyListener &m_listener;
    Plan m_plan;
    std::vector<LabContender> m_contenders;
    std::vector<LabFamily> m_families;
    std::vector<TimedFamily> m_parts; ///< by family
    std::vector<double> m_expected; ///< by row: ns that a draw of the timed part may take
    Study m_study;
};

} // namespace

Study runStudy(const StudySettings &settings, const StudyListener &listener)
{
    return StudyRun(settings, listener).run();
}

} // namespace pixelplumb
