// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/jsontext.h"

#include "core/scene/text/shortened.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double endOfIntegers = 9223372036854775808.0; // 2^63

} // namespace

QString placeOf(const QByteArray &text, qsizetype offset, const QString &path)
{
    constexpr qsizetype longestPath = 200; // characters
    const QByteArrayView before
        = QByteArrayView(text).first(qBound(qsizetype(0), offset, text.size()));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    const QString place = u"line %1, column %2"_s.arg(before.count('\n') + 1)
                              .arg(QString::fromUtf8(before.sliced(lineStart)).size() + 1);
    return path.isEmpty() ? place : place + u", "_s + shortened(path, longestPath);
}

QString memberPath(const QString &parent, const QString &key)
{
    return parent.isEmpty() ? key : parent + u'.' + key;
}

QString elementPath(const QString &parent, qsizetype index)
{
    return parent + u'[' + QString::number(index) + u']';
}

bool JsonText::isString(const JsonValue &each, QAnyStringView meaning) const
{
    const QByteArrayView inside = written(each).sliced(1, each.size - 2);
    return inside.contains('\\') ? QAnyStringView(string(each)) == meaning
                                 : QAnyStringView(QUtf8StringView(inside)) == meaning;
}

QString JsonText::pathOf(quint32 place) const
{
    QString pathSoFar = path;
    for (quint32 parent = 0; parent != place;) {
        const bool isObject = values[parent].kind == JsonKind::Object;
        quint32 child = parent + (isObject ? 2 : 1);
        qsizetype index = 0;
        for (; values[child].next <= place; ++index)
            child = values[child].next + (isObject ? 1 : 0);
        pathSoFar = isObject ? memberPath(pathSoFar, string(values[child - 1]))
                             : elementPath(pathSoFar, index);
        parent = child;
    }
    return pathSoFar;
}

/// Visits the keys of an object until `visit` returns false.
template <class Visit>
void JsonNode::visitMembers(const Visit &visit) const
{
    if (!isObject())
        return;
    const auto &values = m_text->values;
    quint32 place = m_place + 1;
    for (qsizetype left = size(); left > 0 && visit(values[place]); --left)
        place = values[place + 1].next;
}

JsonNode JsonNode::missing(const QString &path) const
{
    JsonNode node = *this;
    node.m_missing = path;
    return node;
}

JsonNode JsonNode::operator[](QAnyStringView key) const
{
    quint32 found = 0;
    visitMembers([&](const JsonValue &each) {
        found = m_text->isString(each, key) ? each.next : 0;
        return found == 0;
    });
    if (found != 0)
        return at(found);
    return missing(memberPath(m_missing, key.toString()));
}

JsonNode JsonNode::operator[](qsizetype index) const
{
    if (!isArray() || index >= size())
        return missing(elementPath(m_missing, index));
    quint32 place = m_place + 1;
    for (qsizetype i = 0; i < index; ++i)
        place = m_text->values[place].next;
    return at(place);
}

QStringList JsonNode::keys() const
{
    QStringList keys;
    visitMembers([&](const JsonValue &key) {
        keys.append(m_text->string(key));
        return true;
    });
    keys.sort();
    return keys;
}

bool JsonNode::hasOnly(const QStringList &keys) const
{
    bool isKnown = true;
    visitMembers([&](const JsonValue &key) {
        isKnown = std::ranges::any_of(
            keys, [&](const QString &each) { return m_text->isString(key, each); });
        return isKnown;
    });
    return isKnown;
}

std::vector<JsonNode> JsonNode::elements() const
{
    std::vector<JsonNode> nodes;
    nodes.reserve(std::size_t(size()));
    visitElements([&](const JsonNode &element) {
        nodes.push_back(element);
        return true;
    });
    return nodes;
}

QString JsonNode::toString() const { return isString() ? m_text->string(value()) : QString(); }

QByteArrayView JsonNode::written() const
{
    return isMissing() || isArray() || isObject() ? QByteArrayView() : m_text->written(value());
}

double JsonNode::toDouble(double otherwise) const
{
    return isNumber() ? written().toDouble() : otherwise;
}

qint64 JsonNode::toInteger(qint64 otherwise) const
{
    if (!isNumber())
        return otherwise;
    const QByteArrayView text = written();
    qint64 integer = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), integer);
    if (end == text.end() && error == std::errc())
        return integer;
    const double number = text.toDouble();
    const bool isInteger
        = std::floor(number) == number && number >= -endOfIntegers && number < endOfIntegers;
    return isInteger ? qint64(number) : otherwise;
}

QString JsonNode::path() const
{
    const QString there = m_text == nullptr ? QString() : m_text->pathOf(m_place);
    if (m_missing.isEmpty())
        return there;
    return m_missing.startsWith(u'[') ? there + m_missing : memberPath(there, m_missing);
}

} // namespace pixelplumb
