// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/familyaccuracy.h"
#include "core/lab/labrace.h"

namespace pixelplumb {

/// What the settings of a study come to.
struct StudyPlan {
    AccuracyOptions accuracy;
    RaceOptions race;
    int rounds = 5;
    bool hasEffects = true; ///< whether effects are measured: in studies of everything
};

/// s that parts of a study take about on two idle cores: rates that were measured once, times how
/// much is asked.
struct StudyTimes {
    double judging = 0; ///< a family
    double round = 0; ///< a family
    double effects = 0;

    double ofAll(std::size_t families, int rounds) const
    {
        return double(families) * (judging + rounds * round) + effects;
    }
};
StudyTimes studyTimesFor(const StudySettings &settings, const StudyPlan &plan);

StudyPlan studyPlanFor(const StudySettings &settings);
/// With the peers.
std::vector<LabContender> contendersFor(const StudySettings &settings);
/// Those that are asked for and that there is something for.
std::vector<LabFamily> familiesFor(const StudySettings &settings);

} // namespace pixelplumb
