// SPDX-License-Identifier: GPL-3.0-or-later
#define ZLIB_CONST
#include "core/scene/text/inflated.h"

#include <zlib.h>

#include <vector>

namespace pixelplumb {

StreamEnd inflate(const QByteArray &stream, const BytesListener &listener)
{
    z_stream state = {};
    if (inflateInit(&state) != Z_OK)
        return StreamEnd::Broken;
    state.next_in = reinterpret_cast<const Bytef *>(stream.constData());
    state.avail_in = uInt(stream.size());
    std::vector<std::uint8_t> block(std::size_t(1) << 16);
    StreamEnd end = StreamEnd::Early;
    for (int result = Z_OK; result == Z_OK;) {
        state.next_out = block.data();
        state.avail_out = uInt(block.size());
        result = ::inflate(&state, Z_NO_FLUSH);
        const std::size_t bytes = block.size() - state.avail_out;
        if (bytes > 0 && !listener(std::span(block).first(bytes))) {
            end = StreamEnd::Stopped;
            break;
        }
        if (result == Z_STREAM_END)
            end = StreamEnd::Whole;
        else if (result != Z_OK && result != Z_BUF_ERROR) // missing bytes are no broken ones
            end = StreamEnd::Broken;
    }
    inflateEnd(&state);
    return end;
}

} // namespace pixelplumb
