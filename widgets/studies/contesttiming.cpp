// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/contesttiming.h"

#include "widgets/model/measuringpool.h"

namespace pixelplumb {

ContestTiming::ContestTiming(QObject *parent)
    : QObject(parent)
    , m_job(nullptr, measuringPool())
{
}

void ContestTiming::measure(const std::shared_ptr<const Contest> &contest)
{
    std::vector<std::shared_ptr<const Scene>> scenes; ///< null for the truth
    for (const ContenderRun &run : contest->runs)
        scenes.push_back(run.contender.isTruth() ? nullptr
                                                 : std::make_shared<const Scene>(
                                                     sceneFor(contest->scene, run.contender)));
    using Costs = std::vector<std::optional<SceneCost>>;
    m_job.start(
        [scenes](const ProgressListener &listener) {
            Costs costs;
            for (const auto &scene : scenes)
                costs.push_back(scene ? costOf(scene, listener) : std::nullopt);
            return costs;
        },
        [this](const Costs &costs) {
            for (std::size_t run = 0; run < costs.size(); ++run) {
                if (costs[run])
                    emit measured(run, *costs[run]);
            }
        });
}

} // namespace pixelplumb
