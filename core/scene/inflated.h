// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <span>

namespace pixelplumb {

/// How a stream that is deflated (RFC 1950) ended.
enum class StreamEnd {
    Whole, ///< and its checksum is right
    Early,
    Broken,
    Stopped, ///< by its listener
};

/// Hears the bytes of a stream, a block after the other; false ends it.
using BytesListener = std::function<bool(std::span<const std::uint8_t> block)>;

StreamEnd inflate(const QByteArray &stream, const BytesListener &listener);

} // namespace pixelplumb
