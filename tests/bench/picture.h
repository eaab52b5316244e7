// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "workload.h"

#include <cstdint>
#include <vector>

namespace pixelplumb::bench {

/// A renderer's frame, independent of its own layout: 0x00rrggbb, row 0 lowest, 0 where nothing was
/// written.
class Picture {
public:
    explicit Picture(FrameSize size)
        : m_size(size)
        , m_pixels(std::size_t(size.width) * std::size_t(size.height), 0)
    {
    }

    FrameSize size() const { return m_size; }
    std::uint32_t at(int x, int y) const { return m_pixels[indexOf(x, y)]; }
    void set(int x, int y, std::uint32_t pixel) { m_pixels[indexOf(x, y)] = pixel & 0xffffff; }

private:
    std::size_t indexOf(int x, int y) const
    {
        return std::size_t(y) * std::size_t(m_size.width) + std::size_t(x);
    }

    FrameSize m_size;
    std::vector<std::uint32_t> m_pixels;
};

/// Converts lines of 32-bit pixels, the highest row first, as most libraries store them.
inline Picture pictureOfLines(FrameSize size, const unsigned char *lines,
                              std::ptrdiff_t bytesPerLine)
{
    Picture picture(size);
    for (int y = 0; y < size.height; ++y) {
        const auto *line = reinterpret_cast<const std::uint32_t *>(
            lines + std::ptrdiff_t(size.height - 1 - y) * bytesPerLine);
        for (int x = 0; x < size.width; ++x)
            picture.set(x, y, line[x]);
    }
    return picture;
}

} // namespace pixelplumb::bench
