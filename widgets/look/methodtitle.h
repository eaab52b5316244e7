// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

struct Method;

/// A method's name in the window's language; in English, as in files, exports and on the command
/// line, where there is no translation.
QString methodTitle(const Method &method);

} // namespace pixelplumb
