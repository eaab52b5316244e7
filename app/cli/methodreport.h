// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

#include <QJsonObject>

namespace pixelplumb::cli {

/// The kinds of primitive the method draws: "triangle", …
QStringList kindsOf(const Method &method);

/// The entry for a method in the list of methods.
QJsonObject jsonOf(const Method &method);

/// Prints all about a method, with its numbers and, for each arithmetic, the summary of its
/// operations on the standard example (core/lab/standardexamples.h).
void printWholeMethod(const Method &method);
QJsonObject jsonOfWhole(const Method &method);

} // namespace pixelplumb::cli
