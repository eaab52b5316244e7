// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// Whether a view tells what lies ahead of its position in a run: a secret where a student
/// foretells it.
enum class Ahead { Shown, Hidden };

} // namespace pixelplumb
