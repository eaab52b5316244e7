// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// What a file is written as.
enum class WrittenAs {
    Export, ///< never over an input
    Document, ///< saved back to where it was opened
};

} // namespace pixelplumb
