// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

namespace pixelplumb {

/// Whether a character of a text from outside is shown as it is: not where it steers a terminal,
/// turns the direction of writing, cannot be seen, or is none.
bool canBeShown(char32_t character);

/// What a program wrote, as it may be shown: valid text in which each control character, and with
/// them each escape sequence, has become U+FFFD (line feeds and tabs stay), cut after so many
/// characters.
QString shownText(const QByteArray &bytes, qsizetype longest = 2000);

/// Each character that cannot be shown as its code, "\x1b", "\u202e", "\U000e0001", line feeds and
/// tabs too: what is quoted of a file or a command line neither colours a terminal nor makes a
/// second line.
QString escapedControls(const QString &text);

/// The same of a text whose line feeds stay.
QString escapedLines(const QString &text);

/// The same of JSON, which means the same then; its layout stays.
QByteArray escapedJson(const QByteArray &json);

/// The first few of many names: "a, b, c, d, e …".
QString fewNames(const QStringList &names);

} // namespace pixelplumb
