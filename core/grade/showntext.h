// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

namespace pixelplumb {

/// What a program wrote, as it may be shown: valid text in which each control character, and with
/// them each escape sequence, has become U+FFFD (line feeds and tabs stay), cut after so many
/// characters.
QString shownText(const QByteArray &bytes, qsizetype longest = 2000);

/// Each control character as its code, "\x1b", line feeds and tabs too: what is quoted of a file or
/// a command line neither colours a terminal nor makes a second line.
QString escapedControls(const QString &text);

/// The first few of many names: "a, b, c, d, e …".
QString fewNames(const QStringList &names);

} // namespace pixelplumb
