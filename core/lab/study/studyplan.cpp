// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/studyplan.h"

namespace pixelplumb {

namespace {

// s per contender
constexpr double quickJudging = 0.065; ///< of a family
constexpr double fullJudging = 0.2; ///< of a family
constexpr double oneRound = 0.0085; ///< of a family
constexpr double effectJudging = 1.5; ///< of all together
constexpr double oneEffectRound = 0.25; ///< of all together

} // namespace

StudyPlan studyPlanFor(const StudySettings &settings)
{
    StudyPlan plan;
    if (settings.extent == StudyExtent::Full) {
        plan.accuracy = {600'000'000, 60, 200'000, 1'000'000, 40'000};
        plan.race.longestDraw = 60e6;
        plan.rounds = 7;
    }
    if (settings.mostSamples > 0)
        plan.accuracy.mostSamples = settings.mostSamples;
    if (settings.hangSeconds > 0)
        plan.accuracy.hangSeconds = settings.hangSeconds;
    if (settings.longestDrawSeconds > 0)
        plan.race.longestDraw = settings.longestDrawSeconds * 1e9;
    if (settings.rounds >= 0)
        plan.rounds = settings.rounds;
    plan.hasEffects = plan.rounds > 0 && settings.contenders.empty() && settings.families.isEmpty();
    return plan;
}

StudyTimes studyTimesFor(const StudySettings &settings, const StudyPlan &plan)
{
    const auto contenders = double(contendersFor(settings).size());
    StudyTimes times;
    times.judging
        = contenders * (settings.extent == StudyExtent::Quick ? quickJudging : fullJudging);
    times.round = contenders * oneRound;
    if (plan.hasEffects)
        times.effects = effectJudging + plan.rounds * oneEffectRound;
    return times;
}

double expectedSeconds(const StudySettings &settings)
{
    const StudyPlan plan = studyPlanFor(settings);
    auto families = std::size_t(settings.families.size());
    if (families == 0)
        families = labFamilies().size() - (settings.ownScene ? 0 : 1);
    return studyTimesFor(settings, plan).ofAll(families, plan.rounds);
}

std::vector<LabContender> contendersFor(const StudySettings &settings)
{
    std::vector<LabContender> contenders = settings.contenders;
    if (contenders.empty())
        contenders = settings.extent == StudyExtent::Quick ? quickContenders() : fullContenders();
    contenders.insert(contenders.end(), settings.peers.begin(), settings.peers.end());
    return contenders;
}

std::vector<LabFamily> familiesFor(const StudySettings &settings)
{
    const FamilyRequest request{settings.seed, settings.extent, settings.ownScene,
                                settings.hardCases};
    std::vector<LabFamily> families;
    for (const LabFamilyInfo &info : labFamilies()) {
        if (!settings.families.isEmpty() && !settings.families.contains(QLatin1String(info.id)))
            continue;
        if (auto family = makeFamily(info, request))
            families.push_back(std::move(*family));
    }
    return families;
}

} // namespace pixelplumb
