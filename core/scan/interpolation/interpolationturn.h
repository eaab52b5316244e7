// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/rowwalk.h"

#include <type_traits>

/// A form of interpolation that goes by rows is scanned by columns of the plane turned to (u, v) =
/// (−y, x), like row edge walking (rowwalk.h).
namespace pixelplumb {

template <InterpolationForm form>
using ViewOfForm = std::conditional_t<axisOf(form) == SpanAxis::Row, TurnedView, FrameView>;

/// What a form reports to: the observer itself where nothing is turned or nobody listens.
template <InterpolationForm form, class Observer>
auto listenerFor(Observer observer)
{
    if constexpr (axisOf(form) == SpanAxis::Column || std::is_same_v<Observer, NullObserver>)
        return observer;
    else
        return AxisListener<SpanAxis::Row, Observer>(observer);
}

/// A triangle as a form scans it, with its attributes. If two vertices coincide, the turned
/// triangle lies between the same two extremes as the original.
template <InterpolationForm form>
struct FormTriangle {
    FormTriangle(const Triangle &of, const TriangleAttributes *carried)
        : triangle(of)
    {
        if (carried)
            attributes = *carried;
        if (axisOf(form) == SpanAxis::Column)
            return;
        const auto &at = [&](std::size_t i) { return of.vertices[i].position; };
        if (at(0) == at(1) || at(1) == at(2) || at(0) == at(2)) {
            const std::array<int, 3> order = sortedByColumn(of);
            triangle = betweenExtremes(of);
            attributes.vertices[std::size_t(order[1])] = attributes.vertices[std::size_t(order[2])];
        }
        triangle = turned(triangle);
    }

    Triangle triangle;
    TriangleAttributes attributes;
};

} // namespace pixelplumb
