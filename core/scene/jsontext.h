// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QAnyStringView>
#include <QByteArray>
#include <QStringList>

#include <vector>

namespace pixelplumb {

enum class JsonKind : quint32 { Null, False, True, Number, String, Array, Object };

/// A value where it stands in its text.
struct JsonValue {
    quint32 offset = 0; ///< of its first byte
    quint32 size = 0; ///< bytes of a number, a string or a word; elements or members
    quint32 next = 0; ///< the place in JsonText::values of what follows it and all that it holds
    JsonKind kind = JsonKind::Null;
};

/// A JSON text (RFC 8259) and where its values stand. Keys and values are read out of the text when
/// they are asked for, so that a number is what the text says, to the last digit.
struct JsonText {
    QByteArray text;
    QString path; ///< of the root in the file; empty for the whole
    /// In the text's order: the root, then what it holds. A member is its key, a string, and then
    /// its value.
    std::vector<JsonValue> values;

    QByteArrayView written(const JsonValue &value) const
    {
        return QByteArrayView(text).sliced(value.offset, value.size);
    }
    /// What a string means: "w\u0069dth" is "width".
    QString string(const JsonValue &string) const;
    bool isString(const JsonValue &string, QAnyStringView meaning) const;
    /// "primitives[0].triangle" of the value at a place in `values`.
    QString pathOf(quint32 place) const;
};

/// Reads a text; an error where it is no JSON, nests deeper than 1024 levels or has a key twice in
/// one object. The elements of `folded`, an array that is a member of the root, are looked through
/// and not kept: a scene has millions of primitives, of which one at a time is needed.
Result<JsonText> parseJson(const QByteArray &text, QByteArrayView folded = {});
/// The value that begins at an offset of a text that was parsed.
JsonText unfolded(const JsonText &whole, quint32 offset, const QString &path,
                  QByteArrayView folded);

/// "line 5, column 33, primitives[0].triangle" of a byte and the path there, which may be empty;
/// columns count characters.
QString placeOf(const QByteArray &text, qsizetype offset, const QString &path);
/// The path of a member of the object, or of an element of the array, at a path.
QString memberPath(const QString &parent, const QString &key);
QString elementPath(const QString &parent, qsizetype index);

/// A value of a JsonText, which outlives it, or one that is missing.
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

    /// Missing where the object has no such key, or the array no such element.
    JsonNode operator[](QAnyStringView key) const;
    JsonNode operator[](qsizetype index) const;
    /// Elements, or members; 0 of anything else.
    qsizetype size() const { return isArray() || isObject() ? qsizetype(value().size) : 0; }
    /// Of an object, in the order of their codes.
    QStringList keys() const;
    bool hasOnly(const QStringList &keys) const; ///< or is no object
    std::vector<JsonNode> elements() const;
    /// Visits the elements of an array until one says false.
    template <class Visit>
    void visitElements(const Visit &visit) const;

    QString toString() const; ///< empty of what is no string
    /// As the text has it, of an array or object nothing.
    QByteArrayView written() const;
    double toDouble(double otherwise) const;
    /// A whole number of 64 bits, however it is written: 100, 1e2, 100.0.
    qint64 toInteger(qint64 otherwise) const;

    QString path() const;
    quint32 offset() const { return value().offset; } ///< of what is missing, its parent's

private:
    bool is(JsonKind kind) const { return !isMissing() && value().kind == kind; }
    const JsonValue &value() const { return m_text->values[m_place]; }
    JsonNode missing(const QString &path) const;
    template <class Visit>
    void visitMembers(const Visit &visit) const;
    JsonNode at(quint32 place) const { return JsonNode(*m_text, place); }

    const JsonText *m_text = nullptr;
    quint32 m_place = 0; ///< of the value, or of the innermost that is there around it
    QString m_missing; ///< where it is not there: its path from there on
};

template <class Visit>
void JsonNode::visitElements(const Visit &visit) const
{
    quint32 place = m_place + 1;
    for (qsizetype left = isArray() ? size() : 0; left > 0 && visit(at(place)); --left)
        place = m_text->values[place].next;
}

} // namespace pixelplumb
