// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <exception>
#include <new>
#include <optional>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// Runs one part of a longer job; an exception ends that part alone. Returns the exception's
/// message, or none where nothing was thrown.
template <class Work>
std::optional<QString> failureOf(const Work &work)
{
    try {
        work();
    } catch (const std::bad_alloc &) {
        return u"it does not fit into memory"_s;
    } catch (const std::exception &exception) {
        return QString::fromLocal8Bit(exception.what());
    }
    return std::nullopt;
}

} // namespace pixelplumb
