// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/effecttiming.h"
#include "core/shade/effectplan.h"

#include <QString>

namespace pixelplumb {

/// "● called for", "○ not called for", "? not ruled out".
QString verdictText(Verdict verdict);

/// What is forced and what that changes, in sentences; empty where nothing is forced. Reports a
/// contradiction between the picture and a verdict.
QString forcingText(const EffectPlan &plan, const Appearance &appearance, Arithmetic arithmetic,
                    std::int64_t changed);

/// How many times as long: "1.24 (1.20 … 1.31)".
QString ratioText(const Spread &ratio);

} // namespace pixelplumb
