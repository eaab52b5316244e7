// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pixelplumb {

/// One sample that a kernel visited, with its pixel before and after, so that replay can go either
/// way (16 bytes). Frames are opaque, so a transparent `after` is free to mean that the sample was
/// refused.
struct PixelChange {
    std::int32_t x = 0;
    std::int32_t y = 0;
    QRgb before = 0;
    QRgb after = 0;

    static PixelChange refused(std::int32_t x, std::int32_t y, QRgb pixel)
    {
        return {x, y, pixel, 0};
    }
    bool isWritten() const { return qAlpha(after) != 0; }

    friend bool operator==(const PixelChange &, const PixelChange &) = default;
};

/// The visits of a run in order. Grows by blocks, so that millions of visits are never copied.
class PixelChanges {
public:
    std::size_t size() const { return m_size; }
    const PixelChange &operator[](std::size_t index) const
    {
        return m_blocks[index / blockSize][index % blockSize];
    }
    void append(const PixelChange &change)
    {
        if (m_size % blockSize == 0)
            m_blocks.push_back(std::make_unique<PixelChange[]>(blockSize));
        m_blocks.back()[m_size % blockSize] = change;
        ++m_size;
    }

private:
    static constexpr std::size_t blockSize = std::size_t(1) << 12;

    std::vector<std::unique_ptr<PixelChange[]>> m_blocks;
    std::size_t m_size = 0;
};

} // namespace pixelplumb
