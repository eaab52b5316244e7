// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/scenetiming.h"

#include <QPalette>
#include <QString>

namespace pixelplumb {

/// The measurement as HTML tables: numbers right-aligned, with few digits.
QString timesHtml(const SceneTiming &timing);
/// Which kernel took how many of the triangles, and why.
QString routesHtml(const FastReport &report, const QPalette &palette);
/// What was measured, in a sentence or two.
QString measurementText(const SceneTiming &timing);

} // namespace pixelplumb
