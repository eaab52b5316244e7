// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QString>

namespace pixelplumb {

/// What the step before a position did: "pixel (27, 19) written".
QString stepText(const TracedScene &traced, std::size_t position);
/// What a mark means: "tie: a sample of this column lies exactly on an edge".
QString markText(const TracedScene &traced, const TraceMark &mark);
/// "column 27, second half", or the triangle that was set up.
QString columnText(const TracedScene &traced, std::size_t position);

} // namespace pixelplumb
