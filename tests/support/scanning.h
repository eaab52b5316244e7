// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/methods/method.h"
#include "core/oracle/oracle.h"
#include "core/scene/scene.h"
#include "tests/support/colours.h"
#include "tests/support/framespec.h"

#include <ostream>

/// Shared helpers of the kernel tests: triangles in short, frames as text.
namespace pixelplumb {

/// A red, green and blue triangle in whole-pixel coordinates.
inline Triangle triangleAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                           std::int64_t x2, std::int64_t y2)
{
    return {{{{latticePixel(x0, y0), red},
              {latticePixel(x1, y1), green},
              {latticePixel(x2, y2), blue}}}};
}

/// A red, green and blue triangle in units of 1/256 px.
inline Triangle triangleAtUnits(LatticePoint a, LatticePoint b, LatticePoint c)
{
    return {{{{a, red}, {b, green}, {c, blue}}}};
}

inline const Method &columnScan() { return *methodNamed(u"column-scan"); }

/// A picture on a background that no kernel writes (alpha 0), so that coverage shows.
class ScanPicture {
public:
    explicit ScanPicture(const FrameSpec &spec)
        : m_frame(spec)
    {
        clear();
    }

    void clear()
    {
        const FrameView view = m_frame.view();
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
                *view.at(x, y) = 0;
        }
    }
    /// Draws with anything that accepts a FrameView.
    template <class Drawer>
    void draw(const Drawer &drawer)
    {
        drawer(m_frame.view());
    }
    void drawByMethod(const Triangle &triangle, const ScanSettings &settings)
    {
        const FrameView frame = m_frame.view();
        Run(&columnScan(), {{triangle}, {}}, settings, frame, Kernels::Plain).draw(frame);
    }
    void drawByOracle(const Triangle &triangle, const ScanSettings &settings)
    {
        oracle::draw(triangle, settings.fillRule, settings.rounding, m_frame.view());
    }
    QRgb at(std::int64_t x, std::int64_t y) const { return *m_frame.view().at(x, y); }
    const FrameSpec &spec() const { return m_frame.spec(); }

    /// The coverage: `#` covered, `.` not; the highest row first.
    QString text() const
    {
        QString text;
        const FrameView view = m_frame.view();
        for (std::int64_t y = view.endRow() - 1; y >= view.firstRow; --y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
                text += at(x, y) != 0 ? u'#' : u'.';
            text += u'\n';
        }
        return text;
    }
    std::int64_t count() const { return text().count(u'#'); }

    friend bool operator==(const ScanPicture &a, const ScanPicture &b)
    {
        const FrameView view = a.m_frame.view();
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
                if (a.at(x, y) != b.at(x, y))
                    return false;
            }
        }
        return true;
    }

private:
    FrameBuffer m_frame;
};

inline QString coverageText(const Triangle &triangle, const FrameSpec &spec,
                            const ScanSettings &settings = {})
{
    ScanPicture drawing(spec);
    drawing.drawByMethod(triangle, settings);
    return drawing.text();
}

/// A triangle in lattice units and colours, for RapidCheck and failure messages.
inline std::ostream &operator<<(std::ostream &stream, const Triangle &triangle)
{
    stream << "units of 1/256 px:";
    for (const Vertex &vertex : triangle.vertices)
        stream << " (" << vertex.position.x << ", " << vertex.position.y << ") #" << std::hex
               << (packed(vertex.colour) & 0xffffffU) << std::dec;
    return stream;
}

} // namespace pixelplumb
