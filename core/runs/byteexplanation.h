// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"
#include "core/trace/scantrace.h"

#include <QRgb>

#include <vector>

namespace pixelplumb {

struct ExactSample;
struct TracedScene;

/// A sample that was written, with the names of its numbers.
struct WrittenSample {
    const std::vector<NumberDescription> &numbers;
    const SampleRecord &sample;
    const ExactSample &exact;
    QRgb pixel; ///< what stands there afterwards
};

/// A line for the byte of each channel: how it comes of the sample's level, or of the last effect
/// that changed the colour.
void appendBytes(Explanation &explanation, const TracedScene &traced, const WrittenSample &written);

} // namespace pixelplumb
