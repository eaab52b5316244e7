// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/rowwriter.h"

namespace pixelplumb {

/// How a text table writes rationals.
enum class TextNumbers {
    Mixed, ///< "5 7/54"
    Decimal, ///< "5.129629…", from cutDecimal() with six places
};

/// An aligned table for people: titles on top, numbers aligned by their whole parts. Rows are
/// collected into blocks; a column grows where a later block needs it and never shrinks.
std::unique_ptr<RowWriter> makeTextWriter(QIODevice &device, TextNumbers numbers);

} // namespace pixelplumb
