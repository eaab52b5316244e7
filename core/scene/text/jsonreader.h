// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/jsontext.h"

#include <optional>

namespace pixelplumb {

/// Reads a JSON text step by step and remembers the first error. After an error every reading
/// function still returns a value of its type, so that a reader is straight-line code that checks
/// for success once, at its end.
class JsonReader {
public:
    JsonReader(const JsonReader &) = delete;
    JsonReader &operator=(const JsonReader &) = delete;
    /// Fails from the start where the text is no JSON, or has a key twice in one object.
    explicit JsonReader(const QByteArray &text, QByteArrayView folded = {});
    /// Reads a value inside another reader's text, such as a folded element.
    JsonReader(const JsonReader &whole, const JsonNode &node, const QString &path,
               QByteArrayView folded = {});

    bool hasFailed() const { return m_error.has_value(); }
    const InputError &error() const { return *m_error; }
    void fail(const JsonNode &node, const QString &found, const QString &expected);
    void fail(const InputError &error);

    JsonNode root() const { return m_text.values.empty() ? JsonNode() : JsonNode(m_text); }

    /// Fails unless the node is an object with no keys but these.
    void expectObject(const JsonNode &node, const QStringList &keys);
    QString string(const JsonNode &node);
    bool boolean(const JsonNode &node);
    /// A number without fraction in [first, last].
    qint64 integer(const JsonNode &node, qint64 first, qint64 last);
    std::vector<JsonNode> array(const JsonNode &node);
    std::vector<JsonNode> array(const JsonNode &node, qsizetype size);

private:
    JsonText m_text;
    std::optional<InputError> m_error;
};

/// A value as a message shows it: "“abc”", "3", "an object", "nothing".
QString describe(const JsonNode &node);

/// A number as it is written to a file: an integer to its last digit, anything else as the shortest
/// decimal for the same double.
QString numberText(double number);

} // namespace pixelplumb
