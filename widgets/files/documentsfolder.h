// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Where a scene is saved that has no folder yet: the person's documents, or, where these have no
/// folder, home. Absolute, and exists: a file dialog takes no proposal in a folder that does not.
QString documentsFolder();

} // namespace pixelplumb
