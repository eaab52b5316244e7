// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// What is written to a file.
enum class WrittenAs {
    Export, ///< never over an input
    Document, ///< what was opened, where it came from
};

} // namespace pixelplumb
