// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/jsonfault.h"

namespace pixelplumb {

QString wholeCharacters() { return QStringLiteral("both \\u escapes of a character, or none"); }

QString expectedAt(rapidjson::ParseErrorCode code, char found)
{
    switch (code) {
    case rapidjson::kParseErrorDocumentRootNotSingular:
        return QStringLiteral("the text's end");
    case rapidjson::kParseErrorObjectMissName:
        return QStringLiteral("a key in quotation marks");
    case rapidjson::kParseErrorObjectMissColon:
        return QStringLiteral("“:”");
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
        return QStringLiteral("“,” or “}”");
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
        return QStringLiteral("“,” or “]”");
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
        return QStringLiteral("four hexadecimal digits after \\u");
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
        return wholeCharacters();
    case rapidjson::kParseErrorStringEscapeInvalid:
        return found == '\\' ? QStringLiteral("one of \" \\ / b f n r t u after \\")
                             : QStringLiteral("the end of a string");
    case rapidjson::kParseErrorStringMissQuotationMark:
        return QStringLiteral("the end of a string");
    case rapidjson::kParseErrorStringInvalidEncoding:
        return QStringLiteral("text in UTF-8");
    case rapidjson::kParseErrorNumberTooBig:
        return QStringLiteral("a number below 1.8e308");
    case rapidjson::kParseErrorNumberMissFraction:
    case rapidjson::kParseErrorNumberMissExponent:
        return QStringLiteral("a digit");
    default:
        return QStringLiteral("a value");
    }
}

QString foundAt(const QByteArray &text, qsizetype offset)
{
    constexpr qsizetype quotedBytes = 12, quotedCharacters = 8;
    if (offset >= text.size())
        return QStringLiteral("the text ends");
    const QString found = QString::fromUtf8(text.mid(offset, quotedBytes));
    return QStringLiteral("“%1”").arg(found.left(quotedCharacters).simplified());
}

} // namespace pixelplumb
