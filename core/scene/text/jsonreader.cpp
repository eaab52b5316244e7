// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/jsonreader.h"

#include "core/scene/text/shortened.h"

#include <QLocale>

#include <cmath>
#include <limits>

namespace pixelplumb {

JsonReader::JsonReader(const QByteArray &text, QByteArrayView folded)
{
    if (Result<JsonText> parsed = parseJson(text, folded))
        m_text = std::move(*parsed);
    else
        m_error = parsed.error();
}

JsonReader::JsonReader(const JsonReader &whole, const JsonNode &node, const QString &path,
                       QByteArrayView folded)
    : m_text(unfolded(whole.m_text, node.offset(), path, folded))
{
}

void JsonReader::fail(const JsonNode &node, const QString &found, const QString &expected)
{
    if (!m_error)
        m_error = InputError{placeOf(m_text.text, node.offset(), node.path()), found, expected};
}

void JsonReader::fail(const InputError &error)
{
    if (!m_error)
        m_error = error;
}

void JsonReader::expectObject(const JsonNode &node, const QStringList &keys)
{
    if (!node.isObject()) {
        fail(node, describe(node), "an object");
        return;
    }
    if (node.hasOnly(keys))
        return;
    for (const QString &key : node.keys()) {
        if (!keys.contains(key)) {
            // For a long key the place is the object.
            fail(key.size() > longestQuote ? node : node[key],
                 u"unknown key “%1”"_s.arg(shortened(key)), u"one of "_s + keys.join(u", "_s));
            return;
        }
    }
}

QString JsonReader::string(const JsonNode &node)
{
    if (!node.isString())
        fail(node, describe(node), "a string");
    const QString text = node.toString();
    if (text.contains(QChar(0))) // a file's name would end there
        fail(node, "a string with the character U+0000", "one without it");
    return text;
}

bool JsonReader::boolean(const JsonNode &node)
{
    if (!node.isBoolean())
        fail(node, describe(node), "true or false");
    return node.isTrue();
}

qint64 JsonReader::integer(const JsonNode &node, qint64 first, qint64 last)
{
    constexpr qint64 none = std::numeric_limits<qint64>::min();
    const qint64 value = node.toInteger(none);
    if (value >= first && value <= last && value != none)
        return value;
    fail(node, describe(node),
         first == last ? u"the integer %1"_s.arg(first)
                       : u"an integer from %1 to %2"_s.arg(first).arg(last));
    return first;
}

std::vector<JsonNode> JsonReader::array(const JsonNode &node)
{
    if (!node.isArray())
        fail(node, describe(node), "an array");
    return node.elements();
}

std::vector<JsonNode> JsonReader::array(const JsonNode &node, qsizetype size)
{
    std::vector<JsonNode> nodes = array(node);
    if (qsizetype(nodes.size()) != size)
        fail(node, describe(node), u"an array of %1"_s.arg(size));
    nodes.resize(std::size_t(size));
    return nodes;
}

QString describe(const JsonNode &node)
{
    if (node.isMissing())
        return u"nothing"_s;
    if (node.isString())
        return u"“%1”"_s.arg(shortened(node.toString()));
    if (node.isArray())
        return u"an array of %1"_s.arg(node.size());
    if (node.isObject())
        return u"an object"_s;
    return shortened(QString::fromUtf8(node.written()));
}

QString numberText(double number)
{
    // −0 is written as 0.
    if (std::floor(number) == number && std::abs(number) < 1e60)
        return QString::number(number + 0.0, 'f', 0);
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

} // namespace pixelplumb
