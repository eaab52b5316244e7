// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QString>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// The member of a results file that reveals edits: a digest (SHA-256, in hexadecimal digits) of
/// all other bytes of the file, and of what it is about.
inline const QString sealKey = u"seal"_s;

/// The object's text with its seal. `about` is the context in which the text is true: a grade
/// belongs to one assignment. A seal is not secret: it reveals slips and edits, not deliberate
/// forgery.
QByteArray sealed(QJsonObject object, const QByteArray &about);

/// Whether no byte has changed since sealed() wrote it with the same `about`.
bool isSealed(const QByteArray &text, const QByteArray &about);

} // namespace pixelplumb
