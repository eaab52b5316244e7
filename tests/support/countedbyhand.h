// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/lab/counting/operationcounts.h"
#include "core/methods/method.h"

#include <QStringList>

/// Operations counted by kernels that run in counting numbers, for comparison with hand counts.
namespace pixelplumb {

inline constexpr std::int32_t side = 16; // px, of every frame here

inline FrameSpec square(std::int32_t pixels)
{
    FrameSpec spec;
    spec.width = pixels;
    spec.height = pixels;
    return spec;
}

/// Columns 0 … 4 have 1, 3, 5, 3 and 1 pixels. All slopes and all colour changes from pixel to
/// pixel are integers, so nothing is ever carried.
inline Primitives tentTriangle()
{
    Triangle triangle;
    triangle.vertices = {{{latticePixel(0, 0), {{0, 0, 0}}},
                          {latticePixel(4, 0), {{80, 40, 0}}},
                          {latticePixel(2, 4), {{40, 80, 20}}}}};
    return {{triangle}, {}};
}

inline OperationCounts countsOf(const char *method, Arithmetic arithmetic,
                                const Primitives &primitives, std::int32_t pixels = side)
{
    const FrameBuffer frame(square(pixels));
    ScanSettings settings = methodNamed(QString::fromLatin1(method))->adapted({});
    settings.arithmetic = arithmetic;
    return countOperations(*methodNamed(QString::fromLatin1(method)), settings, primitives,
                           frame.view())
        .value();
}

/// The differences in words; empty if a stage has exactly these counts.
inline QString departure(const OperationCounts &counts, WorkStage stage,
                         const std::vector<std::pair<Operation, std::int64_t>> &expected)
{
    OperationRow wanted = {};
    for (const auto &[operation, count] : expected)
        wanted[std::size_t(operation)] = count;
    QStringList differing;
    for (const Operation operation : allOperations) {
        if (counts.of(stage, operation) != wanted[std::size_t(operation)])
            differing.append(u"%1 %2 instead of %3"_s.arg(counts.of(stage, operation))
                                 .arg(QString::fromLatin1(nameOf(operation).data()))
                                 .arg(wanted[std::size_t(operation)]));
    }
    return differing.join(u", "_s);
}

} // namespace pixelplumb
