// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/jsonreader.h"

#include "core/scene/jsonplaces.h"
#include "core/scene/shortened.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <cmath>
#include <limits>

namespace pixelplumb {

JsonNode JsonNode::operator[](const QString &key) const
{
    return {value.isObject() ? value.toObject().value(key) : QJsonValue(QJsonValue::Undefined),
            memberPath(path, key)};
}

JsonNode JsonNode::operator[](qsizetype index) const
{
    const QJsonArray elements = value.toArray();
    return {index < elements.size() ? elements.at(index) : QJsonValue(QJsonValue::Undefined),
            elementPath(path, index)};
}

JsonReader::JsonReader(const QByteArray &text, const JsonExcerpt &excerpt)
    : m_text(text)
    , m_excerpt(excerpt)
{
    m_root.path = excerpt.path;
    if (text.trimmed().isEmpty()) {
        m_error = InputError{{}, QStringLiteral("the input is empty"), QStringLiteral("JSON")};
        return;
    }
    // QJsonDocument reads no number or string by itself; an element of an array may be one.
    if (!m_root.path.isEmpty() && text[0] != '{' && text[0] != '[') {
        m_root.value = QJsonDocument::fromJson('[' + text + ']').array().at(0);
        return;
    }
    QJsonParseError parseError;
    const QJsonDocument document = QJsonDocument::fromJson(text, &parseError);
    if (parseError.error != QJsonParseError::NoError) {
        m_error = InputError{linePlace(excerpt.whole, excerpt.offsetInWhole(parseError.offset)),
                             parseError.errorString(), QStringLiteral("JSON")};
        return;
    }
    m_root.value
        = document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object());
    if (const auto repeated = repeatedJsonKey(text))
        failAt(repeated->offset,
               m_root.path.isEmpty() ? repeated->path : memberPath(m_root.path, repeated->path),
               QStringLiteral("the key is there twice"), QStringLiteral("every key once"));
}

void JsonReader::fail(const JsonNode &node, const QString &found, const QString &expected)
{
    if (m_error)
        return;
    // A key that is missing has no place of its own: its object has.
    std::optional<qsizetype> offset = offsetOf(node.path);
    for (QString path = node.path; !offset && path.size() > m_root.path.size();) {
        path.truncate(qMax(qsizetype(0), qMax(path.lastIndexOf(u'.'), path.lastIndexOf(u'['))));
        offset = offsetOf(path);
    }
    failAt(offset.value_or(0), node.path, found, expected);
}

std::optional<qsizetype> JsonReader::offsetOf(const QString &path) const
{
    QString inExcerpt = path.sliced(m_root.path.size());
    if (!m_root.path.isEmpty() && inExcerpt.startsWith(u'.'))
        inExcerpt.remove(0, 1);
    return offsetOfJsonValue(m_text, inExcerpt);
}

void JsonReader::failAt(qsizetype offset, const QString &path, const QString &found,
                        const QString &expected)
{
    constexpr qsizetype longestPath = 200; // characters
    const QString line = linePlace(m_excerpt.whole, m_excerpt.offsetInWhole(offset));
    m_error = InputError{
        path.isEmpty() ? line : line + QStringLiteral(", ") + shortened(path, longestPath), found,
        expected};
}

void JsonReader::expectObject(const JsonNode &node, const QStringList &keys)
{
    if (!node.value.isObject()) {
        fail(node, describe(node), QStringLiteral("an object"));
        return;
    }
    const QStringList present = node.value.toObject().keys();
    for (const QString &key : present) {
        if (!keys.contains(key)) {
            // Of a long one the object is the place.
            fail(key.size() > longestQuote ? node : node[key],
                 QStringLiteral("unknown key “%1”").arg(shortened(key)),
                 QStringLiteral("one of ") + keys.join(QStringLiteral(", ")));
            return;
        }
    }
}

QString JsonReader::string(const JsonNode &node)
{
    if (!node.value.isString())
        fail(node, describe(node), QStringLiteral("a string"));
    return node.value.toString();
}

bool JsonReader::boolean(const JsonNode &node)
{
    if (!node.value.isBool())
        fail(node, describe(node), QStringLiteral("true or false"));
    return node.value.toBool();
}

qint64 JsonReader::integer(const JsonNode &node, qint64 first, qint64 last)
{
    constexpr qint64 none = std::numeric_limits<qint64>::min();
    const qint64 value = node.value.toInteger(none);
    if (value >= first && value <= last && value != none)
        return value;
    fail(node, describe(node),
         first == last ? QStringLiteral("the integer %1").arg(first)
                       : QStringLiteral("an integer from %1 to %2").arg(first).arg(last));
    return first;
}

std::vector<JsonNode> JsonReader::array(const JsonNode &node)
{
    if (!node.value.isArray())
        fail(node, describe(node), QStringLiteral("an array"));
    const QJsonArray elements = node.value.toArray();
    std::vector<JsonNode> nodes;
    nodes.reserve(std::size_t(elements.size()));
    for (qsizetype index = 0; index < elements.size(); ++index)
        nodes.push_back({elements.at(index), elementPath(node.path, index)});
    return nodes;
}

std::vector<JsonNode> JsonReader::array(const JsonNode &node, qsizetype size)
{
    std::vector<JsonNode> nodes = array(node);
    if (qsizetype(nodes.size()) != size)
        fail(node, describe(node), QStringLiteral("an array of %1").arg(size));
    nodes.resize(std::size_t(size));
    return nodes;
}

QString describe(const JsonNode &node)
{
    switch (node.value.type()) {
    case QJsonValue::Undefined:
        return QStringLiteral("nothing");
    case QJsonValue::Null:
        return QStringLiteral("null");
    case QJsonValue::Bool:
        return node.value.toBool() ? QStringLiteral("true") : QStringLiteral("false");
    case QJsonValue::Double:
        return numberText(node.value);
    case QJsonValue::String:
        return QStringLiteral("“%1”").arg(shortened(node.value.toString()));
    case QJsonValue::Array:
        return QStringLiteral("an array of %1").arg(node.value.toArray().size());
    case QJsonValue::Object:
        return QStringLiteral("an object");
    }
    return {};
}

QString numberText(const QJsonValue &number)
{
    constexpr qint64 none = std::numeric_limits<qint64>::min();
    if (const qint64 integer = number.toInteger(none); integer != none)
        return QString::number(integer);
    const double value = number.toDouble();
    if (std::floor(value) == value && std::abs(value) < 1e60)
        return QString::number(value, 'f', 0);
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

} // namespace pixelplumb
