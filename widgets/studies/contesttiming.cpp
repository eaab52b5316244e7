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
    using Figures = std::vector<std::optional<LiveFigures>>;
    m_job.start(
        [scenes](const ProgressListener &listener) {
            Figures figures;
            for (const auto &scene : scenes)
                figures.push_back(scene ? liveFiguresOf(scene, listener) : std::nullopt);
            return figures;
        },
        [this](const Figures &figures) {
            for (std::size_t run = 0; run < figures.size(); ++run) {
                if (figures[run])
                    emit measured(run, *figures[run]);
            }
        });
}

} // namespace pixelplumb
