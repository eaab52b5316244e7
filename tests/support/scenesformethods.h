// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QString>

#include <utility>
#include <vector>

namespace pixelplumb {

/// A scene, and what it is called in messages.
using NamedScene = std::pair<QString, Scene>;

/// The examples that call for nothing beyond colour, cropped to what a test has time for, and
/// scenes on which a method may stumble: empty ones, zero areas, vertices at ±2^30 px, several
/// kinds of primitives in one.
std::vector<NamedScene> scenesForEveryMethod();

/// The scene's run by a method in one of its arithmetics; a rule that it does not know is replaced
/// by one that it does.
std::shared_ptr<const TracedScene> tracedBy(const Method &method, Arithmetic arithmetic,
                                            Scene scene);

} // namespace pixelplumb
