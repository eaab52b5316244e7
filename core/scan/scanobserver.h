// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/columnstate.h"

#include <concepts>

namespace pixelplumb {

/// Why a triangle draws nothing.
enum class TriangleRejection {
    ZeroArea, ///< no colour plane, and only the closed rule paints a segment or a point
    OutsideFrame, ///< no sample of the frame lies within its bounding box
    NotRepresentable, ///< a coordinate does not fit the arithmetic (fixed 16.16: |c| < 2^15 px)
};

/// What hears a kernel at work: a closed list of events, each announced before the change that it
/// names. Observers are passed by value and return nothing; one that does nothing compiles to
/// nothing.
template <class Observer, class A>
concept ScanObserver
    = std::copy_constructible<Observer> && requires(Observer observer, const ColumnSetUp<A> &setUp,
                                                    const ColumnState<A> &column,
                                                    const Fragment<A> &fragment,
                                                    TriangleRejection reason,
                                                    std::int64_t coordinate, QRgb pixel)
{
    {
        observer.triangleBegun(setUp)
        } -> std::same_as<void>;
    {
        observer.triangleRejected(reason)
        } -> std::same_as<void>;
    {
        observer.columnEntered(column)
        } -> std::same_as<void>;
    {
        observer.pixelWritten(coordinate, coordinate, pixel, pixel, fragment)
        } -> std::same_as<void>;
};

/// Hears nothing: plain drawing.
struct NullObserver {
    template <class SetUp>
    void triangleBegun(const SetUp &)
    {
    }
    void triangleRejected(TriangleRejection) { }
    template <class Column>
    void columnEntered(const Column &)
    {
    }
    template <class AnyFragment>
    void pixelWritten(std::int64_t, std::int64_t, QRgb, QRgb, const AnyFragment &)
    {
    }
};

} // namespace pixelplumb
