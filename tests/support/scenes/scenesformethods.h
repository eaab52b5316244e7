// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QString>

#include <utility>
#include <vector>

namespace pixelplumb {

/// A scene and its name in messages.
using NamedScene = std::pair<QString, Scene>;

/// The examples that need nothing beyond colour, cropped to keep the tests fast, and scenes that
/// may trip a method: empty ones, zero areas, vertices at ±2^30 px, several kinds of primitives in
/// one.
std::vector<NamedScene> scenesForEveryMethod();

/// The scene traced by a method in one of its arithmetics; a fill rule that the method does not
/// know is replaced by one that it knows.
std::shared_ptr<const TracedScene> tracedBy(const Method &method, Arithmetic arithmetic,
                                            Scene scene);

} // namespace pixelplumb
