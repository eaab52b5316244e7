// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>

namespace pixelplumb {

struct TracedScene;

/// What is said of a primitive before it is drawn: where it is, then the method's own words, which
/// name a triangle's vertices themselves; and whether its coordinates are the scene's.
QString setUpSentence(const TracedScene &traced, std::size_t primitive, const QString &words);

} // namespace pixelplumb
