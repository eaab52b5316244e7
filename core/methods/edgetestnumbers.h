// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgeteststeps.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

/// The numbers of an edge test, by the names of the form's slides.
NumberTable<EdgeTestSetUpState> edgeTestSetUpNumbers(const EdgeTestForm &form);
NumberTable<EdgeTestSpanState> edgeTestSpanNumbers(const EdgeTestForm &form);
NumberTable<EdgeTestSampleState> edgeTestSampleNumbers(const EdgeTestForm &form);

} // namespace pixelplumb
