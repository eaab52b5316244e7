// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationcounts.h"

#include <span>
#include <string_view>

namespace pixelplumb {

/// A method whose kernel is also compiled with counting numbers.
struct CountedMethod {
    std::string_view id;
    std::optional<OperationCounts> (*count)(const Primitives &primitives,
                                            const ScanSettings &settings, FrameView frame,
                                            const ProgressListener &progress);
};

std::span<const CountedMethod> countedTriangleMethods();
std::span<const CountedMethod> countedShapeMethods();

} // namespace pixelplumb
