// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"

#include <QAnyStringView>
#include <QByteArray>
#include <QStringList>

#include <vector>

namespace pixelplumb {

enum class JsonKind : quint32 { Null, False, True, Number, String, Array, Object };

/// The position of a value in its text.
struct JsonValue {
    quint32 offset = 0; ///< of its first byte
    quint32 size = 0; ///< bytes of a number, string or word; count of elements or members
    quint32 next = 0; ///< the place in JsonText::values after this value and its content
    JsonKind kind = JsonKind::Null;
};

/// A JSON text (RFC 8259) and the positions of its values. Keys and values are read from the text
/// on request, so that a number is what the text says, to the last digit.
struct JsonText {
    QByteArray text;
    QString path; ///< of the root in the file; empty for a whole file
    /// In the order of the text: the root, then its content. A member is its key, a string, then
    /// its value.
    std::vector<JsonValue> values;

    QByteArrayView written(const JsonValue &value) const
    {
        return QByteArrayView(text).sliced(value.offset, value.size);
    }
    /// What a string means: "w\u0069dth" is "width".
    QString string(const JsonValue &string) const;
    bool isString(const JsonValue &string, QAnyStringView meaning) const;
    /// The path "primitives[0].triangle" of the value at a place in `values`.
    QString pathOf(quint32 place) const;
};

/// Parses a text; an error where it is no JSON, nests deeper than 1024 levels or has a key twice in
/// one object. The elements of `folded`, an array that is a member of the root, are checked but not
/// kept: a scene has millions of primitives, needed one at a time.
Result<JsonText> parseJson(const QByteArray &text, QByteArrayView folded = {});
/// The value that begins at an offset of a text already parsed.
JsonText unfolded(const JsonText &whole, quint32 offset, const QString &path,
                  QByteArrayView folded);

/// "line 5, column 33, primitives[0].triangle" for a byte offset and its path, which may be empty;
/// columns count characters.
QString placeOf(const QByteArray &text, qsizetype offset, const QString &path);
/// The path of an object's member, or of an array's element.
QString memberPath(const QString &parent, const QString &key);
QString elementPath(const QString &parent, qsizetype index);

/// A value of a JsonText, which must outlive the node, or a missing value.
class JsonNode {
public:
    JsonNode() = default; ///< missing, nowhere
    explicit JsonNode(const JsonText &text, quint32 place = 0)
        : m_text(&text)
        , m_place(place)
    {
    }

    bool isMissing() const { return m_text == nullptr || !m_missing.isEmpty(); }
    bool isNumber() const { return is(JsonKind::Number); }
    bool isString() const { return is(JsonKind::String); }
    bool isArray() const { return is(JsonKind::Array); }
    bool isObject() const { return is(JsonKind::Object); }
    bool isBoolean() const { return is(JsonKind::True) || is(JsonKind::False); }
    bool isTrue() const { return is(JsonKind::True); }

    /// A missing node where the object has no such key, or the array no such element.
    JsonNode operator[](QAnyStringView key) const;
    JsonNode operator[](qsizetype index) const;
    /// Elements or members; 0 for any other value.
    qsizetype size() const { return isArray() || isObject() ? qsizetype(value().size) : 0; }
    /// An object's keys in the order of their codes.
    QStringList keys() const;
    bool hasOnly(const QStringList &keys) const; ///< also true if it is no object
    std::vector<JsonNode> elements() const;
    /// Visits the elements of an array until `visit` returns false.
    template <class Visit>
    void visitElements(const Visit &visit) const;

    QString toString() const; ///< empty unless it is a string
    /// The value as written in the text; nothing for an array or object.
    QByteArrayView written() const;
    double toDouble(double otherwise) const;
    /// A whole number of 64 bits in any notation: 100, 1e2, 100.0.
    qint64 toInteger(qint64 otherwise) const;

    QString path() const;
    quint32 offset() const { return value().offset; } ///< a missing value has its parent's

private:
    bool is(JsonKind kind) const { return !isMissing() && value().kind == kind; }
    const JsonValue &value() const { return m_text->values[m_place]; }
    JsonNode missing(const QString &path) const;
    template <class Visit>
    void visitMembers(const Visit &visit) const;
    JsonNode at(quint32 place) const { return JsonNode(*m_text, place); }

    const JsonText *m_text = nullptr;
    quint32 m_place = 0; ///< of the value; where it is missing, of its innermost existing parent
    QString m_missing; ///< of a missing value: its path from that parent on
};

template <class Visit>
void JsonNode::visitElements(const Visit &visit) const
{
    quint32 place = m_place + 1;
    for (qsizetype left = isArray() ? size() : 0; left > 0 && visit(at(place)); --left)
        place = m_text->values[place].next;
}

} // namespace pixelplumb
