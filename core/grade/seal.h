// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QString>

namespace pixelplumb {

/// The member of a file of results by which it tells that somebody has edited it: a digest
/// (SHA-256, in hexadecimal digits) of all other bytes of the file, and of what it is about.
inline const QString sealKey = QStringLiteral("seal");

/// The object's text with its seal. `about` is what the text is true of: a grade is one of a
/// certain assignment. A seal keeps no secret: it tells of a slip or an edit, not of somebody who
/// means to forge results.
QByteArray sealed(QJsonObject object, const QByteArray &about);

/// Whether not a byte has changed since sealed() wrote it about the same.
bool isSealed(const QByteArray &text, const QByteArray &about);

} // namespace pixelplumb
