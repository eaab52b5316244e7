// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <sys/stat.h>

namespace pixelplumb {

/// The name of what is no regular file: "a link".
inline QString fileKindOf(mode_t mode)
{
    switch (mode & S_IFMT) {
    case S_IFLNK:
        return QStringLiteral("a link");
    case S_IFIFO:
        return QStringLiteral("a pipe");
    case S_IFDIR:
        return QStringLiteral("a folder");
    case S_IFSOCK:
        return QStringLiteral("a socket");
    default:
        return QStringLiteral("a device");
    }
}

} // namespace pixelplumb
