// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>

namespace pixelplumb {

/// How many bytes a stream of zlib's (RFC 1950) gives before it ends or is broken; it is not gone
/// through beyond `most`.
std::uint64_t inflatedBytes(const QByteArray &stream, std::uint64_t most);

} // namespace pixelplumb
