// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/methods/walks/edgewalknumbers.h"

namespace pixelplumb {

/// The colours of a span: at both bounds, their change between them and where they start.
void appendEdgeWalkColours(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names);

} // namespace pixelplumb
