// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <rapidjson/error/error.h>

namespace pixelplumb {

/// What is wrong with a JSON text, and where.
struct JsonFault {
    quint32 offset = 0;
    QString path; ///< empty where the text is no JSON and has no paths
    QString found; ///< empty: the text at the offset
    QString expected;
};

/// What should stand where RapidJSON reports an error.
QString expectedAt(rapidjson::ParseErrorCode code, char found);
/// What is expected in place of half a surrogate pair.
QString wholeCharacters();
/// The text at an offset, as a message quotes it.
QString foundAt(const QByteArray &text, qsizetype offset);

} // namespace pixelplumb
