// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

struct Method;

/// The sentence that a method says of itself, in the window's language; in English where that has
/// no words for it.
QString methodSummary(const Method &method);

} // namespace pixelplumb
