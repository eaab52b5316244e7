// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <string_view>

/// The names of settings (nameOf() in scansettings.h and similar headers) as QStrings.
namespace pixelplumb {

inline QString nameText(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

/// The names of several choices, in their order.
template <class Choices>
QStringList namesOf(const Choices &choices)
{
    QStringList names;
    for (const auto choice : choices)
        names.append(nameText(nameOf(choice)));
    return names;
}

} // namespace pixelplumb
