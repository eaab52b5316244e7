// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/studytime.h"

#include "core/lab/studyplan.h"

namespace pixelplumb {

namespace {

/// s of one contender on one family.
struct Rates {
    double judging;
    double round; ///< of timing
};

constexpr Rates quickRates = {0.065, 0.0085};
constexpr Rates fullRates = {0.2, 0.012};
constexpr double growthRate = 0.05; ///< s of one contender in one round

} // namespace

double expectedSecondsOf(const StudySettings &settings)
{
    const StudyPlan plan = studyPlanFor(settings);
    const Rates &rates = settings.extent == StudyExtent::Quick ? quickRates : fullRates;
    std::size_t families = std::size_t(settings.families.size());
    if (families == 0)
        families = labFamilies().size() - (settings.ownScene ? 0 : 1);
    const double rows = double(contendersFor(settings).size() * families);
    return rows * (rates.judging + plan.rounds * rates.round)
        + double(plan.growing.size()) * plan.growthRounds * growthRate;
}

} // namespace pixelplumb
