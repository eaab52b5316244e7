// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <exception>
#include <optional>

namespace pixelplumb {

/// Does some work of a contender: what it throws ends that contender, not the study. What was
/// thrown; none where nothing was.
template <class Work>
std::optional<QString> failureOf(const Work &work)
{
    try {
        work();
    } catch (const std::exception &exception) {
        return QString::fromLocal8Bit(exception.what());
    }
    return std::nullopt;
}

} // namespace pixelplumb
