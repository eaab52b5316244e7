// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

#include <QJsonObject>

namespace pixelplumb::cli {

/// "triangle", …: what it draws.
QStringList kindsOf(const Method &method);

/// What a list says of each method.
QJsonObject jsonOf(const Method &method);

/// Everything, with its numbers and, for each arithmetic, the résumé of its operations on the
/// standard example (core/lab/standardexamples.h).
void printWholeMethod(const Method &method);
QJsonObject jsonOfWhole(const Method &method);

} // namespace pixelplumb::cli
