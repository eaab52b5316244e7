// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <QString>

#include <concepts>
#include <type_traits>

/// The names of fields in files: one list for each part, eachField(part, visit), by which
/// FieldReader and jsonOf() read and write it.
namespace pixelplumb {

template <class Self, class T>
concept PartOf = std::same_as<std::remove_const_t<Self>, T>;

/// A part that has fields.
template <class T>
concept HasFields = requires(T &part)
{
    eachField(part, [](const char *, const auto &) {});
};

/// The names of an enumeration's values in files.
template <class Enum>
struct FileWords;
template <>
struct FileWords<Arithmetic> {
    static constexpr const auto &all = allArithmetics;
};
template <>
struct FileWords<FillRule> {
    static constexpr const auto &all = allFillRules;
};
template <>
struct FileWords<ByteRounding> {
    static constexpr const auto &all = allByteRoundings;
};

inline QString fileWord(const QString &name) { return name; }
inline QString fileWord(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

} // namespace pixelplumb
