// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// The most characters quoted from a file or a command line.
inline constexpr qsizetype longestQuote = 60;

/// A text as a message quotes it: whole, or its beginning and an ellipsis.
inline QString shortened(const QString &text, qsizetype longest = longestQuote)
{
    if (text.size() <= longest)
        return text;
    // Keeps both halves of a surrogate pair, or neither.
    const qsizetype end = longest - (text[longest - 1].isHighSurrogate() ? 1 : 0);
    return text.first(end) + u"…"_s;
}

} // namespace pixelplumb
