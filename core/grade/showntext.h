// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

namespace pixelplumb {

/// What a program wrote, as it may be shown: valid text in which each control character, and with
/// them each escape sequence, has become U+FFFD (line feeds and tabs stay), cut after so many
/// characters.
QString shownText(const QByteArray &bytes, qsizetype longest = 2000);

/// The first few of many names: "a, b, c, d, e …".
QString fewNames(const QStringList &names);

} // namespace pixelplumb
