// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/familyaccuracy.h"
#include "core/lab/study/labrace.h"

namespace pixelplumb {

/// What the settings of a study amount to.
struct StudyPlan {
    AccuracyOptions accuracy;
    RaceOptions race;
    int rounds = 5;
    bool hasEffects = true; ///< whether effects are measured: in studies of everything
};

/// About how many s parts of a study take on two idle cores: rates that were measured once, times
/// the amount of work.
struct StudyTimes {
    double judging = 0; ///< per family
    double round = 0; ///< per family
    double effects = 0;

    double ofAll(std::size_t families, int rounds) const
    {
        return double(families) * (judging + rounds * round) + effects;
    }
};
StudyTimes studyTimesFor(const StudySettings &settings, const StudyPlan &plan);

StudyPlan studyPlanFor(const StudySettings &settings);
/// Includes the peers.
std::vector<LabContender> contendersFor(const StudySettings &settings);
/// The requested families that have something to draw.
std::vector<LabFamily> familiesFor(const StudySettings &settings);

} // namespace pixelplumb
