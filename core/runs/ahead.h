// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// Whether a view shows what lies ahead of its position in a run: hidden where a student predicts
/// it.
enum class Ahead { Shown, Hidden };

} // namespace pixelplumb
