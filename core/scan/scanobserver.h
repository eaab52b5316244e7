// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"

#include <QRgb>

#include <concepts>
#include <cstdint>

namespace pixelplumb {

/// An observer of a kernel: it receives a closed list of events, each announced before the change
/// that it names. A span is the run of samples that a kernel walks together: a column, a row, or
/// one step of a curve. `Numbers` names the kernel's SetUp, Span and Sample. Observers are passed
/// by value and return nothing; one that does nothing compiles to nothing.
template <class Observer, class Numbers>
concept ScanObserver = std::copy_constructible<Observer> && requires(
    Observer observer, const typename Numbers::SetUp &setUp, const typename Numbers::Span &span,
    const typename Numbers::Sample &sample, Rejection reason, std::int64_t coordinate, QRgb pixel)
{
    {
        observer.primitiveBegun(setUp)
        } -> std::same_as<void>;
    {
        observer.primitiveRejected(reason)
        } -> std::same_as<void>;
    {
        observer.spanEntered(span)
        } -> std::same_as<void>;
    {
        observer.sampleRejected(coordinate, coordinate, pixel, sample)
        } -> std::same_as<void>;
    {
        observer.pixelWritten(coordinate, coordinate, pixel, pixel, sample)
        } -> std::same_as<void>;
};

/// Ignores every event: plain drawing.
struct NullObserver {
    template <class SetUp>
    void primitiveBegun(const SetUp &)
    {
    }
    void primitiveRejected(const Rejection &) { }
    template <class Span>
    void spanEntered(const Span &)
    {
    }
    template <class Sample>
    void sampleRejected(std::int64_t, std::int64_t, QRgb, const Sample &)
    {
    }
    template <class Sample>
    void pixelWritten(std::int64_t, std::int64_t, QRgb, QRgb, const Sample &)
    {
    }
};

/// Whether an observer reads the numbers in its events. For one that does not, a kernel need not
/// compute what the picture does not show.
template <class Observer>
inline constexpr bool readsNumbers = true;
template <>
inline constexpr bool readsNumbers<NullObserver> = false;

} // namespace pixelplumb
