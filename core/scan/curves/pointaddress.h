// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// Points by their address (Rasterization slides, "Point Plotting"): M[addr] = colour with
/// addr = y·width + x, counted from the frame's first pixel.
namespace pixelplumb {

/// The memory that the addresses count.
struct PointSetUp {
    std::int64_t width = 0;
    std::int64_t firstColumn = 0;
    std::int64_t firstRow = 0;
};

struct PointStep {
    std::int64_t number = 0; ///< of the point, from 0
    std::int64_t x = 0; ///< the nearest pixel; ties go right and up
    std::int64_t y = 0;
    bool isInFrame = false;
    std::int64_t address = 0; ///< meaningful only in the frame
};

struct PointNumbers {
    using SetUp = PointSetUp;
    using Span = PointStep;
    using Sample = FlatSample;
};

/// The address of a pixel in the frame.
template <class Integer>
std::int64_t addressOf(std::int64_t x, std::int64_t y, FrameView frame)
{
    return std::int64_t((Integer(y) - frame.firstRow) * frame.width
                        + (Integer(x) - frame.firstColumn));
}

template <class Integer, ScanObserver<PointNumbers> Observer>
void plotPoints(const Shape &points, FrameView frame, Observer observer)
{
    observer.primitiveBegun(PointSetUp{frame.width, frame.firstColumn, frame.firstRow});
    PointStep step;
    for (const Vertex &vertex : points.vertices) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        step.x = floorPixel(vertex.position.x + unitsPerPixel / 2);
        step.y = floorPixel(vertex.position.y + unitsPerPixel / 2);
        step.isInFrame = frame.contains(step.x, step.y);
        step.address = step.isInFrame ? addressOf<Integer>(step.x, step.y, frame) : 0;
        observer.spanEntered(step);
        // The real memory may pad its rows: the pixel is found from the address alone.
        if (step.isInFrame)
            writeFlat(frame.firstColumn + step.address % frame.width,
                      frame.firstRow + step.address / frame.width, vertex.colour, frame, observer);
        ++step.number;
    }
}

} // namespace pixelplumb
