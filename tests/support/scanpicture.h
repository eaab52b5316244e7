// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/oracle/oracle.h"
#include "tests/support/framespec.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

/// A picture on a background that no kernel writes (alpha 0), so that coverage shows.
class ScanPicture {
public:
    explicit ScanPicture(const FrameSpec &spec)
        : m_spec(spec)
        , m_pixels(std::size_t(spec.width) * std::size_t(spec.height), QRgb(0))
    {
    }

    FrameView view()
    {
        FrameView view = windowOf(m_spec);
        view.base = m_pixels.data();
        view.stride = m_spec.width;
        return view;
    }
    const FrameSpec &spec() const { return m_spec; }
    const std::vector<QRgb> &pixels() const { return m_pixels; }
    QRgb at(std::int64_t x, std::int64_t y) const
    {
        return m_pixels[std::size_t((y - m_spec.firstRow) * m_spec.width + x - m_spec.firstColumn)];
    }
    void clear() { std::ranges::fill(m_pixels, QRgb(0)); }

    /// Draws with anything that accepts a FrameView.
    template <class Drawer>
    void draw(const Drawer &drawer)
    {
        drawer(view());
    }
    void draw(const Method &method, const Triangle &triangle, const ScanSettings &settings)
    {
        Run(&method, {{triangle}, {}}, settings, view(), Kernels::Plain).draw(view());
    }
    void drawTruth(const Triangle &triangle, const ScanSettings &settings)
    {
        oracle::draw(triangle, {settings, view()}, settings.rounding, view());
    }

    /// The coverage: `#` covered, `.` not; the highest row first.
    QString text() const
    {
        QString text;
        for (std::int64_t row = m_spec.height - 1; row >= 0; --row) {
            for (std::int64_t column = 0; column < m_spec.width; ++column)
                text += at(m_spec.firstColumn + column, m_spec.firstRow + row) != 0 ? u'#' : u'.';
            text += u'\n';
        }
        return text;
    }
    std::int64_t count() const
    {
        return std::ranges::count_if(m_pixels, [](QRgb pixel) { return pixel != 0; });
    }

    friend bool operator==(const ScanPicture &a, const ScanPicture &b)
    {
        return a.m_pixels == b.m_pixels;
    }

private:
    FrameSpec m_spec;
    std::vector<QRgb> m_pixels;
};

} // namespace pixelplumb
