// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"

#include <ostream>
#include <vector>

namespace pixelplumb {

/// The order of a frame's rows in memory.
enum class RowOrder { Ascending, Descending };

/// Where a window lies in the plane of samples and in the surrounding memory.
struct WindowSpec {
    std::int32_t width = 64;
    std::int32_t height = 48;
    std::int32_t firstColumn = 0;
    std::int32_t firstRow = 0;
    std::int32_t padding = 0; ///< pixels from the end of a row to the next row
    RowOrder order = RowOrder::Ascending;
};

inline std::ostream &operator<<(std::ostream &out, const WindowSpec &spec)
{
    return out << spec.width << " x " << spec.height << " from (" << spec.firstColumn << ", "
               << spec.firstRow << "), padding " << spec.padding << ", rows "
               << (spec.order == RowOrder::Ascending ? "ascending" : "descending");
}

/// A window inside memory that no kernel may change: equality compares all of it.
class GuardedFrame {
public:
    explicit GuardedFrame(const WindowSpec &spec)
        : m_spec(spec)
        , m_memory(std::size_t(lineLength()) * std::size_t(spec.height) + 2 * guard, untouched)
    {
    }

    FrameView view()
    {
        FrameView view;
        const bool ascending = m_spec.order == RowOrder::Ascending;
        view.base = m_memory.data() + guard + (ascending ? 0 : (m_spec.height - 1) * lineLength());
        view.stride = ascending ? lineLength() : -lineLength();
        view.firstColumn = m_spec.firstColumn;
        view.firstRow = m_spec.firstRow;
        view.width = m_spec.width;
        view.height = m_spec.height;
        return view;
    }

    friend bool operator==(const GuardedFrame &a, const GuardedFrame &b)
    {
        return a.m_memory == b.m_memory;
    }

    /// The index of the first pixel that differs, in memory order, from the start of the window.
    friend std::ptrdiff_t firstDifference(const GuardedFrame &a, const GuardedFrame &b)
    {
        for (std::size_t i = 0; i < a.m_memory.size(); ++i) {
            if (a.m_memory[i] != b.m_memory[i])
                return std::ptrdiff_t(i) - std::ptrdiff_t(guard);
        }
        return -1;
    }

private:
    static constexpr std::size_t guard = 64;
    static constexpr QRgb untouched = 0x00c0ffee;

    std::ptrdiff_t lineLength() const { return std::ptrdiff_t(m_spec.width) + m_spec.padding; }

    WindowSpec m_spec;
    std::vector<QRgb> m_memory;
};

} // namespace pixelplumb
