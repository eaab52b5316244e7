// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/tileboxes.h"

namespace pixelplumb {

void TileBoxes::take(std::span<const DepthBox> boxes, std::span<const std::uint32_t> places,
                     const TileCorner &corner, const std::vector<bool> &inQuestion)
{
    const std::size_t size = (places.size() + together - 1) / together * together;
    if (m_left.size() < size) {
        for (std::vector<std::int32_t> *each : {&m_left, &m_right, &m_low, &m_high, &m_nearest,
                                                &m_farthest, &m_outside, &m_inQuestion})
            each->resize(size);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const DepthBox &box = boxes[places[i]];
        m_left[i] = box.left;
        m_right[i] = box.right;
        m_low[i] = box.low;
        m_high[i] = box.high;
        m_nearest[i] = box.nearest;
        m_farthest[i] = box.farthest;
        m_outside[i] = std::int32_t(box.left < corner.x) + 2 * std::int32_t(box.low < corner.y);
        m_inQuestion[i] = inQuestion[places[i]] ? -1 : 0;
    }
}

} // namespace pixelplumb
