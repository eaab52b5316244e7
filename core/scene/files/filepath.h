// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// A path that a person wrote, to be given to Qt: it always names a file. Qt takes one that begins
/// with a colon for a resource of the program.
inline QString filePath(const QString &path)
{
    return path.startsWith(u':') ? u"./"_s + path : path;
}

} // namespace pixelplumb
