// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inflated.h"

#include <zlib.h>

#include <vector>

namespace pixelplumb {

std::uint64_t inflatedBytes(const QByteArray &stream, std::uint64_t most)
{
    z_stream state = {};
    if (inflateInit(&state) != Z_OK)
        return 0;
    QByteArray input = stream; // zlib asks for bytes that may be changed
    state.next_in = reinterpret_cast<Bytef *>(input.data());
    state.avail_in = uInt(input.size());
    std::vector<Bytef> block(std::size_t(1) << 16);
    int result = Z_OK;
    while (result == Z_OK && state.total_out < most) {
        state.next_out = block.data();
        state.avail_out = uInt(block.size());
        result = inflate(&state, Z_NO_FLUSH);
    }
    const std::uint64_t bytes = state.total_out;
    inflateEnd(&state);
    return bytes;
}

} // namespace pixelplumb
