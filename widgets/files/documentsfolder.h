// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Where a scene without a folder is saved: the person's documents, or home where there is no such
/// folder. Absolute and existing: a file dialog takes no proposal in a folder that does not exist.
QString documentsFolder();

} // namespace pixelplumb
