// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"

#include <QJsonObject>
#include <QStringList>

namespace pixelplumb::cli {

/// The effects with their verdicts and reasons, in aligned columns, then the batches.
QStringList textOf(const EffectPlan &plan, const EffectForcing &forced);
QJsonObject jsonOf(const EffectPlan &plan, const EffectForcing &forced);

} // namespace pixelplumb::cli
