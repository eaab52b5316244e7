// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/columnstate.h"
#include "core/scan/scansettings.h"

#include <cstddef>
#include <cstdint>

/// The state of a kernel at one step, in its own numbers, with its context: what the step's numbers
/// and words are read from.
namespace pixelplumb {

template <class SetUp>
struct CurrentSetUp {
    std::size_t primitive = 0;
    const ScanSettings &settings;
    const SetUp &setUp;
};

template <class SetUp, class Span>
struct CurrentSpan : CurrentSetUp<SetUp> {
    const Span &span;
    const Span *previous = nullptr; ///< the primitive's span before this one
};

template <class SetUp, class Span, class Sample>
struct CurrentSample : CurrentSpan<SetUp, Span> {
    const Sample &sample;
    std::int64_t x = 0;
    std::int64_t y = 0;
    SampleFate fate = SampleFate::Written;
};

} // namespace pixelplumb
