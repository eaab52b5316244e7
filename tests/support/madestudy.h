// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <memory>

namespace pixelplumb {

/// One row of a made-up study: ns per pixel, wrong bytes in a million pixels.
struct MadeContender {
    const char *id;
    double perPixel;
    std::int64_t wrongBytes;
    bool isProved = false;
};

/// A study of two families, "f" and "g"; only "f" is timed.
inline std::shared_ptr<Study> madeResults(const std::vector<MadeContender> &contenders)
{
    auto results = std::make_shared<Study>();
    Study &study = *results;
    study.command = u"pixelplumb-cli lab --quick --seed 1"_s;
    study.conditions.processor = u"a processor"_s;
    study.rounds = 5;
    for (const char *id : {"f", "g"}) {
        StudyFamily family;
        family.id = QLatin1String(id);
        family.title = u"Family %1"_s.arg(family.id);
        family.timedTriangles = 10;
        family.timedColumns = 200;
        family.timedRows = 300;
        family.timedPixels = 1000;
        study.families.push_back(family);
        for (const MadeContender &made : contenders) {
            LabRow row;
            row.contender = QLatin1String(made.id);
            row.family = family.id;
            row.outcome = LabOutcome::Measured;
            row.settings.arithmetic = Arithmetic::Float32;
            row.accuracy.emplace().pixels = 1'000'000;
            row.accuracy->wrongBytes = made.wrongBytes;
            if (family.id == u"f"_s) {
                const double draw = made.perPixel * 1000;
                row.cost.emplace().perDraw = {draw * 0.9, draw, draw * 1.1};
                row.cost->rounds = 5;
            }
            study.rows.push_back(row);
        }
    }
    for (const MadeContender &made : contenders) {
        const QString id = QLatin1String(made.id);
        study.contenders.push_back(
            {id, id, kernelOf(id), made.isProved, u"all triangles"_s, CostFit{20, 3, 0.5, 0}});
    }
    return results;
}

} // namespace pixelplumb
