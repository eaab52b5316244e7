// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

/// The rows [first, end) of a frame.
inline FrameView rowsOf(FrameView frame, std::int64_t first, std::int64_t end)
{
    frame.base = frame.at(frame.firstColumn, first);
    frame.firstRow = std::int32_t(first);
    frame.height = std::int32_t(end - first);
    return frame;
}

/// A copy of some rows of a frame, to restore them after they have been drawn over.
class KeptRows {
public:
    explicit KeptRows(FrameView rows)
        : m_rows(rows)
        , m_pixels(std::size_t(rows.width) * std::size_t(rows.height))
    {
        auto kept = m_pixels.begin();
        for (std::int64_t y = rows.firstRow; y < rows.endRow(); ++y)
            kept = std::copy_n(rows.at(rows.firstColumn, y), rows.width, kept);
    }
    void putBack() const
    {
        auto kept = m_pixels.begin();
        for (std::int64_t y = m_rows.firstRow; y < m_rows.endRow(); ++y, kept += m_rows.width)
            std::copy_n(kept, m_rows.width, m_rows.at(m_rows.firstColumn, y));
    }

private:
    FrameView m_rows;
    std::vector<QRgb> m_pixels;
};

} // namespace pixelplumb
