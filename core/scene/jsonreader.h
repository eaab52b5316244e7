// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QByteArray>
#include <QJsonValue>
#include <QStringList>

#include <limits>
#include <optional>
#include <vector>

namespace pixelplumb {

/// A value of a JSON text with its path, "primitives[0].triangle", so that an error can name it.
struct JsonNode {
    QJsonValue value = QJsonValue(QJsonValue::Undefined);
    QString path;

    bool isMissing() const { return value.isUndefined(); }
    /// Missing where the object has no such key, or the array no such element.
    JsonNode operator[](const QString &key) const;
    JsonNode operator[](qsizetype index) const;
};

/// Where a text stands that was cut out of a larger one, so that errors name places in that.
struct JsonExcerpt {
    const QByteArray &whole; ///< outlives the reader
    QString path; ///< of the excerpt's root in the whole; empty for the root
    qsizetype offset = 0; ///< of the excerpt's first byte in the whole
    /// From this byte of the excerpt on, `gap` more bytes of the whole were left out.
    qsizetype gapAt = std::numeric_limits<qsizetype>::max();
    qsizetype gap = 0;

    qsizetype offsetInWhole(qsizetype inExcerpt) const
    {
        return offset + inExcerpt + (inExcerpt >= gapAt ? gap : 0);
    }
};

/// Reads a JSON text step by step and remembers the first thing that is wrong with it. After an
/// error every reading function still returns a value of its type, so that a reader is
/// straight-line code that looks once, at its end, whether it succeeded.
class JsonReader {
public:
    /// A text that is no JSON, or that has a key twice in one object, is an error from the start.
    explicit JsonReader(const QByteArray &text)
        : JsonReader(text, JsonExcerpt{text, {}})
    {
    }
    /// An excerpt below the root is a value of a text that is known to be JSON.
    JsonReader(const QByteArray &text, const JsonExcerpt &excerpt);

    bool hasFailed() const { return m_error.has_value(); }
    const InputError &error() const { return *m_error; }
    void fail(const JsonNode &node, const QString &found, const QString &expected);

    const JsonNode &root() const { return m_root; }

    /// An object with no keys but these.
    void expectObject(const JsonNode &node, const QStringList &keys);
    QString string(const JsonNode &node);
    bool boolean(const JsonNode &node);
    /// A number without fraction in [first, last].
    qint64 integer(const JsonNode &node, qint64 first, qint64 last);
    std::vector<JsonNode> array(const JsonNode &node);
    std::vector<JsonNode> array(const JsonNode &node, qsizetype size);

private:
    void failAt(qsizetype offset, const QString &path, const QString &found,
                const QString &expected);

    /// Of the value at a path of the whole, in the excerpt.
    std::optional<qsizetype> offsetOf(const QString &path) const;

    QByteArray m_text;
    JsonExcerpt m_excerpt;
    JsonNode m_root;
    std::optional<InputError> m_error;
};

/// A value as a message tells it: "“abc”", "3", "an object", "nothing".
QString describe(const JsonNode &node);

/// A JSON number in decimal: an integer to the last digit, anything else as the shortest decimal
/// that means the same double, which is what the file says when that has no more than 15 digits.
QString numberText(const QJsonValue &number);

} // namespace pixelplumb
