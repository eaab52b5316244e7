// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

namespace pixelplumb {

/// Whether a character of foreign text is shown as it is: not if it controls a terminal, changes
/// the direction of writing, is invisible, or is no character.
bool canBeShown(char32_t character);

/// A program's output made safe to show: valid text in which each control character, and so each
/// escape sequence, has become U+FFFD (line feeds and tabs stay), cut after `longest` characters.
QString shownText(const QByteArray &bytes, qsizetype longest = 2000);

/// The text with each character that cannot be shown replaced by its code, "\x1b", "\u202e",
/// "\U000e0001", including line feeds and tabs: what is quoted from a file or a command line
/// neither colours a terminal nor makes a second line.
QString escapedControls(const QString &text);

/// Like escapedControls(), but line feeds stay.
QString escapedLines(const QString &text);

/// JSON escaped in this way, with the same meaning; its layout stays.
QByteArray escapedJson(const QByteArray &json);

/// The first few of many names: "a, b, c, d, e …".
QString fewNames(const QStringList &names);

} // namespace pixelplumb
