// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <span>

namespace pixelplumb {

/// How a deflated stream (RFC 1950) ended.
enum class StreamEnd {
    Whole, ///< with the right checksum
    Early,
    Broken,
    Stopped, ///< by its listener
};

/// Receives the bytes of a stream block by block; false ends it.
using BytesListener = std::function<bool(std::span<const std::uint8_t> block)>;

StreamEnd inflate(const QByteArray &stream, const BytesListener &listener);

} // namespace pixelplumb
