// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

struct Method;

/// A method's sentence about itself, in the window's language; in English where there is no
/// translation.
QString methodSummary(const Method &method);

} // namespace pixelplumb
