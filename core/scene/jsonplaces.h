// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace pixelplumb {

/// Where in a JSON text things stand, for messages. QJsonDocument keeps neither places nor repeated
/// keys; these functions walk a text that it has accepted.

/// "line 5, column 33" of a byte; columns count characters.
QString linePlace(const QByteArray &text, qsizetype offset);

/// The byte where the value at a path such as "primitives[0].triangle[1]" begins; "" is the whole
/// text.
std::optional<qsizetype> offsetOfJsonValue(const QByteArray &text, const QString &path);

struct RepeatedJsonKey {
    QString path; ///< of the second value
    qsizetype offset = 0;
};

/// The first key that an object has twice.
std::optional<RepeatedJsonKey> repeatedJsonKey(const QByteArray &text);

/// The path of a member of the object, or of an element of the array, at a path.
QString memberPath(const QString &parent, const QString &key);
QString elementPath(const QString &parent, qsizetype index);

} // namespace pixelplumb
