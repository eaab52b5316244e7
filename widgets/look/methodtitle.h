// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

struct Method;

/// What a method is called in the window's language; in English, as files, exports and the command
/// line call it, where that has no words for it.
QString methodTitle(const Method &method);

} // namespace pixelplumb
