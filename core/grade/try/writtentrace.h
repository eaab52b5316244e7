// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/number/quantity.h"
#include "core/scan/spanaxis.h"
#include "core/scene/text/result.h"

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <vector>

namespace pixelplumb {

/// A number as a program printed it.
struct WrittenNumber {
    QString text; ///< "41.5", "290/7", "nan"
    Quantity value; ///< exactly what was printed
    /// Half a unit of the last digit printed; 0 for a fraction, and for a whole number, which may
    /// come from an integer division.
    double halfUnit = 0;
    bool isWhole = false; ///< printed without a point, exponent or slash
};

/// A line of a program's own trace (resources/student-program.md). Since programs print millions of
/// lines, its numbers stay in the text.
struct WrittenLine {
    /// Of a column or row; none for a pixel.
    std::optional<SpanAxis> axis;
    std::int32_t x = 0; ///< px; 0 for a row
    std::int32_t y = 0; ///< px; 0 for a column
    std::optional<std::uint32_t> triangle; ///< where the program names it
    qsizetype start = 0; ///< offset in the text
};

/// Which lines a program prints.
struct LineKinds {
    bool hasColumns = false;
    bool hasRows = false;
    bool hasPixels = false;

    bool hasAny() const { return hasColumns || hasRows || hasPixels; }
};

/// What a program printed about a frame, line by line.
struct ProgramTrace {
    QByteArray text;
    std::vector<WrittenLine> lines; ///< those within the frame
    std::int64_t beyondFrame = 0; ///< lines that are dropped: nothing is drawn there
    LineKinds kinds; ///< of all lines
    std::optional<std::uint32_t> lastTriangle; ///< the largest number that it names

    /// y_B and y_T of a column, x_L and x_R of a row, or R, G and B of a pixel.
    std::vector<WrittenNumber> numbersOf(const WrittenLine &line) const;
};

/// Parses lines of at most 200 bytes each, at most 2^22 of them; empty ones are skipped.
Result<ProgramTrace> parseWrittenTrace(const QByteArray &text, const FrameSpec &frame);

} // namespace pixelplumb
