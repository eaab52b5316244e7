// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <variant>

namespace pixelplumb {

using namespace Qt::StringLiterals; // u"…"_s is a QString

/// What is wrong with input from the user or a file: where, what was found, what is expected.
struct InputError {
    QString place; ///< "line 5, column 33, primitives[0].triangle[1][0]"; empty for the whole input
    QString found; ///< "3e9 is outside ±1073741824 px"
    QString expected; ///< "a coordinate such as 26"; empty where `found` says it all

    /// One line: "place: found; expected what".
    QString message() const;

    friend bool operator==(const InputError &, const InputError &) = default;
};

/// What was read, or why it could not be.
template <class Value>
class Result {
public:
    Result(Value value) // NOLINT(google-explicit-constructor): `return value;` is the point
        : m_content(std::move(value))
    {
    }
    Result(InputError error) // NOLINT(google-explicit-constructor)
        : m_content(std::move(error))
    {
    }

    bool isOk() const { return std::holds_alternative<Value>(m_content); }
    explicit operator bool() const { return isOk(); }

    const Value &value() const { return std::get<Value>(m_content); }
    Value &value() { return std::get<Value>(m_content); }
    const InputError &error() const { return std::get<InputError>(m_content); }

    const Value &operator*() const { return value(); }
    Value &operator*() { return value(); }
    const Value *operator->() const { return &value(); }
    Value *operator->() { return &value(); }

private:
    std::variant<Value, InputError> m_content;
};

} // namespace pixelplumb
