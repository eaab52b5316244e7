// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/edgeteststeps.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

class EdgeTestNames;

/// The numbers of an edge test, by the names of the form's slides.
NumberTable<EdgeTestSetUpState> edgeTestSetUpNumbers(const EdgeTestForm &form);
NumberTable<EdgeTestSpanState> edgeTestSpanNumbers(const EdgeTestForm &form);
NumberTable<EdgeTestSampleState> edgeTestSampleNumbers(const EdgeTestForm &form);

/// Appends who owns a sample exactly on an edge, and the numbers by which the fill rule decides.
void appendTies(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names);

} // namespace pixelplumb
