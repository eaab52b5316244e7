// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QStringList>

namespace pixelplumb {

struct TracedScene;

// By which formulas a recorded run computed its numbers: for each number of a level those that
// explainStep() has for it, each once, in the order in which the run came to them, as "a; b". Empty
// where there is none, or where progress ended the search.

QStringList setUpFormulas(const TracedScene &traced);
QStringList spanFormulas(const TracedScene &traced, const ProgressListener &progress);
QStringList sampleFormulas(const TracedScene &traced, const ProgressListener &progress);

} // namespace pixelplumb
