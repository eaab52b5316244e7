// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// How someone else's program is confined: by its limits and, where available, by bubblewrap's
/// sandbox (its own namespaces, an empty folder, no one else's files).
enum class Confinement { Sandbox, LimitsAlone };

/// Why there is no sandbox here: "bubblewrap (bwrap) is not installed"; empty where there is one.
/// Tested once, with a program that does nothing.
const QString &sandboxLack();

/// The sandbox if available.
Confinement bestConfinement();

/// A sentence on what a program could do without a sandbox, and why there is none.
QString unsandboxedText(const QString &lack);

} // namespace pixelplumb
