// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/spanaxis.h"
#include "core/scene/result.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A number as a program printed it.
struct WrittenNumber {
    QString text; ///< "41.5", "290/7", "nan"
    Quantity value; ///< exactly what was printed
    /// Half a unit of the last digit printed; 0 of a fraction and of a whole number, which an
    /// integer division leaves.
    double halfUnit = 0;
    bool isWhole = false; ///< printed without a point, an exponent and a slash
};

/// A line of a program's own trace (resources/student-program.md).
struct WrittenLine {
    /// Of a column or a row; none of a pixel.
    std::optional<SpanAxis> axis;
    std::int64_t x = 0; ///< px; of a row 0
    std::int64_t y = 0; ///< px; of a column 0
    std::optional<std::size_t> triangle; ///< where the program says it
    /// y_B and y_T of a column, x_L and x_R of a row, R, G and B of a pixel.
    std::vector<WrittenNumber> numbers;
};

/// Lines of at most 200 bytes each, at most 2^22 of them; empty ones are passed over.
Result<std::vector<WrittenLine>> parseWrittenTrace(const QByteArray &text);

} // namespace pixelplumb
