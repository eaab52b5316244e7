// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/curves/circleshape.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// A filled circle or ellipse by spans: on each row the samples from x_L to x_R, where the row
/// meets the curve (Scan Conversion slides, "Edge Walking", with a curve for its edges).
namespace pixelplumb {

struct CircleFillRow {
    std::int64_t y = 0; ///< px
    Lattice left = 0; ///< x_L rounded up to the lattice: the first lattice point inside
    Lattice right = 0; ///< x_R rounded down to the lattice
    std::int64_t firstSample = 0, endSample = 0; ///< ⌈x_L⌉ and one past ⌊x_R⌋
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< the same, clipped to the frame
    Colour colour;
};

struct CircleFillNumbers {
    using SetUp = Round;
    using Span = CircleFillRow;
    using Sample = FlatSample;
};

/// Writes the row's samples from left to right.
template <class Observer>
void fillRow(const CircleFillRow &row, FrameView frame, Observer observer)
{
    for (std::int64_t x = row.firstDrawn; x < row.endDrawn; ++x)
        writeFlat(x, row.y, row.colour, frame, observer);
}

template <class Integer, ScanObserver<CircleFillNumbers> Observer>
void fillCircle(const Shape &shape, FrameView frame, Observer observer)
{
    const Round round = Round::of(shape);
    observer.primitiveBegun(round);
    const StepRange rows = round.rows().clippedTo(StepRange::along(frame, LineAxis::Y));
    if (rows.isEmpty() || !round.mayTouch(frame)) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    for (std::int64_t y = rows.first; y < rows.end; ++y) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        CircleFillRow row;
        row.y = y;
        row.colour = shape.vertices[0].colour;
        const Lattice half
            = halfChord<Integer>(round.radiusY, round.radiusX, y * unitsPerPixel - round.centre.y);
        row.left = Lattice(Integer(round.centre.x) - half);
        row.right = Lattice(Integer(round.centre.x) + half);
        row.firstSample = ceilPixel(row.left);
        row.endSample = floorPixel(row.right) + 1;
        const StepRange drawn = StepRange{row.firstSample, row.endSample}.clippedTo(
            StepRange::along(frame, LineAxis::X));
        row.firstDrawn = drawn.first;
        row.endDrawn = std::max(drawn.first, drawn.end);
        observer.spanEntered(row);
        fillRow(row, frame, observer);
    }
}

} // namespace pixelplumb
