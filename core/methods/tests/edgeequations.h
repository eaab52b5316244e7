// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

// The rows of the table of methods for edge equations, in the slides' forms and in a stable one.
Method edgeEquationsMethod();
Method incrementalEdgeEquationsMethod();
Method solvedEdgeEquationsMethod();
Method canonicalEdgeEquationsMethod();

} // namespace pixelplumb
