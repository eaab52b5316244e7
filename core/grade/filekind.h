// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <sys/stat.h>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// The name of what is no regular file: "a link".
inline QString fileKindOf(mode_t mode)
{
    switch (mode & S_IFMT) {
    case S_IFLNK:
        return u"a link"_s;
    case S_IFIFO:
        return u"a pipe"_s;
    case S_IFDIR:
        return u"a folder"_s;
    case S_IFSOCK:
        return u"a socket"_s;
    default:
        return u"a device"_s;
    }
}

} // namespace pixelplumb
