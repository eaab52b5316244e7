// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// How a program of others is held: its limits, and where that can be had bubblewrap's sandbox
/// (namespaces of its own, an empty folder, nobody else's files).
enum class Confinement { Sandbox, LimitsAlone };

/// Why programs of others run in no sandbox here: "bubblewrap (bwrap) is not installed"; empty
/// where they run in one. It is tried once, by a program that does nothing.
const QString &sandboxLack();

/// The sandbox where there is one.
Confinement bestConfinement();

/// A sentence for every output, with why there is none: what a program without a sandbox could do.
QString unsandboxedText(const QString &lack);

} // namespace pixelplumb
