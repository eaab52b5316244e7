// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"
#include "core/measure/effecttiming.h"

#include <QJsonObject>
#include <QStringList>

namespace pixelplumb::cli {

struct PlanReport {
    EffectPlan plan;
    EffectForcing forced;
    std::optional<EffectTiming> timing; ///< where it was measured
    QString refusal = {}; ///< why no method draws the scene; then nothing runs
};

/// The effects with their verdicts and reasons, in aligned columns, then the batches, then what was
/// measured.
QStringList textOf(const PlanReport &report);
QJsonObject jsonOf(const PlanReport &report);

} // namespace pixelplumb::cli
