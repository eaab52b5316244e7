// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/studystages.h"

namespace pixelplumb {

namespace {

/// s of one contender on one family.
struct Rates {
    double judging;
    double round; ///< of timing
    int rounds;
};

constexpr Rates quickRates = {0.065, 0.0085, 5};
constexpr Rates fullRates = {0.2, 0.0085, 7};
constexpr double sizeRate = 0.05; ///< s of one contender in one round

} // namespace

std::vector<JobStage> stagesOf(const StudySettings &settings)
{
    const bool isQuick = settings.extent == StudyExtent::Quick;
    const Rates &rates = isQuick ? quickRates : fullRates;
    std::size_t contenders = settings.contenders.size();
    if (contenders == 0)
        contenders = isQuick ? quickContenders().size() : fullContenders().size();
    std::size_t families = std::size_t(settings.families.size());
    if (families == 0)
        families = labFamilies().size() - (settings.ownScene ? 0 : 1);
    const double rows = double(contenders * families);
    const int rounds = settings.rounds < 0 ? rates.rounds : settings.rounds;
    std::vector<JobStage> stages = {{JobPhase::Judging, rows * rates.judging}};
    if (rounds > 0)
        stages.push_back({JobPhase::Measuring, rows * rates.round * rounds});
    return stages;
}

JobStage sizeStudyStage(std::size_t contenders, int rounds)
{
    return {JobPhase::Measuring, double(contenders) * sizeRate * rounds};
}

} // namespace pixelplumb
