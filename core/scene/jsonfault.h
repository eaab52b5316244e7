// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <rapidjson/error/error.h>

namespace pixelplumb {

/// What is wrong with a JSON text, and where.
struct JsonFault {
    quint32 offset = 0;
    QString path; ///< empty where the text is no JSON: what stands there has none
    QString found; ///< empty: what stands there
    QString expected;
};

/// What should stand where RapidJSON found something else.
QString expectedAt(rapidjson::ParseErrorCode code, char found);
/// What stands in place of half a character.
QString wholeCharacters();
/// What stands at an offset, as a message quotes it.
QString foundAt(const QByteArray &text, qsizetype offset);

} // namespace pixelplumb
