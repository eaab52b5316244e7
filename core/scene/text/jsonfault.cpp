// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/jsonfault.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString wholeCharacters() { return u"both \\u escapes of a character, or none"_s; }

QString expectedAt(rapidjson::ParseErrorCode code, char found)
{
    switch (code) {
    case rapidjson::kParseErrorDocumentRootNotSingular:
        return u"the text's end"_s;
    case rapidjson::kParseErrorObjectMissName:
        return u"a key in quotation marks"_s;
    case rapidjson::kParseErrorObjectMissColon:
        return u"“:”"_s;
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
        return u"“,” or “}”"_s;
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
        return u"“,” or “]”"_s;
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
        return u"four hexadecimal digits after \\u"_s;
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
        return wholeCharacters();
    case rapidjson::kParseErrorStringEscapeInvalid:
        return found == '\\' ? u"one of \" \\ / b f n r t u after \\"_s : u"the end of a string"_s;
    case rapidjson::kParseErrorStringMissQuotationMark:
        return u"the end of a string"_s;
    case rapidjson::kParseErrorStringInvalidEncoding:
        return u"text in UTF-8"_s;
    case rapidjson::kParseErrorNumberTooBig:
        return u"a number below 1.8e308"_s;
    case rapidjson::kParseErrorNumberMissFraction:
    case rapidjson::kParseErrorNumberMissExponent:
        return u"a digit"_s;
    default:
        return u"a value"_s;
    }
}

QString foundAt(const QByteArray &text, qsizetype offset)
{
    constexpr qsizetype quotedBytes = 12, quotedCharacters = 8;
    if (offset >= text.size())
        return u"the text ends"_s;
    const QString found = QString::fromUtf8(text.mid(offset, quotedBytes));
    return u"“%1”"_s.arg(found.left(quotedCharacters).simplified());
}

} // namespace pixelplumb
