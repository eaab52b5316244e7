// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/explanation.h"
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
    QRgb pixel; ///< the pixel afterwards
};

/// Appends a line for each channel's byte: how it follows from the sample's level, or from the last
/// effect that changed the colour.
void appendBytes(Explanation &explanation, const TracedScene &traced, const WrittenSample &written);

} // namespace pixelplumb
