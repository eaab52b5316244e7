// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/number/quantity.h"
#include "core/scan/spanaxis.h"
#include "core/scene/result.h"

#include <QByteArray>

#include <cstdint>
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

/// A line of a program's own trace (resources/student-program.md). Programs print millions: its
/// numbers stay in the text.
struct WrittenLine {
    /// Of a column or a row; none of a pixel.
    std::optional<SpanAxis> axis;
    std::int32_t x = 0; ///< px; of a row 0
    std::int32_t y = 0; ///< px; of a column 0
    std::optional<std::uint32_t> triangle; ///< where the program says it
    qsizetype start = 0; ///< in the text
};

/// Which lines a program prints.
struct LineKinds {
    bool hasColumns = false;
    bool hasRows = false;
    bool hasPixels = false;

    bool hasAny() const { return hasColumns || hasRows || hasPixels; }
};

/// What a program printed of a frame, line by line.
struct ProgramTrace {
    QByteArray text;
    std::vector<WrittenLine> lines; ///< those within the frame
    std::int64_t beyondFrame = 0; ///< lines that are not kept: nothing is drawn there
    LineKinds kinds; ///< of all lines
    std::optional<std::uint32_t> lastTriangle; ///< the largest number that it names

    /// y_B and y_T of a column, x_L and x_R of a row, R, G and B of a pixel.
    std::vector<WrittenNumber> numbersOf(const WrittenLine &line) const;
};

/// Lines of at most 200 bytes each, at most 2^22 of them; empty ones are passed over.
Result<ProgramTrace> parseWrittenTrace(const QByteArray &text, const FrameSpec &frame);

} // namespace pixelplumb
