// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/rowwriter.h"
#include "core/trace/tracedscene.h"

#include <functional>

namespace pixelplumb {

/// The table of a trace by spans: a row a column, a row or a step of the method.
std::vector<Field> spanFields(const Method &method);
QStringList spanCells(const TracedScene &traced, std::size_t span);

/// The table of a trace by samples. Calls `write` for each sample of a span in order.
std::vector<Field> sampleFields(const Method &method);
void forEachSampleRow(const TracedScene &traced, std::size_t span,
                      const std::function<void(const QStringList &cells)> &write);

} // namespace pixelplumb
