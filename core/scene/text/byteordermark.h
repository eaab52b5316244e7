// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace pixelplumb {

/// What programs of Windows put before text in UTF-8.
inline constexpr QByteArrayView byteOrderMark = "\xef\xbb\xbf";

inline QByteArray withoutByteOrderMark(const QByteArray &text)
{
    return text.startsWith(byteOrderMark) ? text.sliced(byteOrderMark.size()) : text;
}

/// Whether it begins like text in UTF-16, as a shell of Windows writes it; no picture does.
inline bool isUtf16(const QByteArray &text)
{
    return text.startsWith("\xff\xfe") || text.startsWith("\xfe\xff");
}

} // namespace pixelplumb
