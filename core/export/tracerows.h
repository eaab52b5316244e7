// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/rowwriter.h"
#include "core/trace/tracedscene.h"

#include <functional>

namespace pixelplumb {

/// The table of a trace at column level.
std::vector<Field> columnFields(const Method &method);
QStringList columnCells(const TracedScene &traced, std::size_t column);

/// The table of a trace at pixel level. Calls `write` for each of a column's pixels, bottom to top.
std::vector<Field> pixelFields();
void forEachPixelRow(const TracedScene &traced, std::size_t column,
                     const std::function<void(const QStringList &cells)> &write);

} // namespace pixelplumb
