// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QStringList>

namespace pixelplumb {

struct TracedScene;

// The formulas by which a recorded run computed its numbers: for each number of a level those of
// explainStep(), each once, in the order of the run, as "a; b". Empty if there is none, or if
// progress ended the search.

QStringList setUpFormulas(const TracedScene &traced);
QStringList spanFormulas(const TracedScene &traced, const ProgressListener &progress);
QStringList sampleFormulas(const TracedScene &traced, const ProgressListener &progress);

} // namespace pixelplumb
