// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/difference.h"
#include "core/frame/writtenframe.h"
#include "core/methods/run.h"

#include <QByteArray>
#include <QString>

#include <functional>

namespace pixelplumb {

/// A function that draws primitives in sample coordinates: a method, or the truth.
using Drawing = std::function<void(const Primitives &primitives, const ScanSettings &settings,
                                   FrameView frame)>;

Drawing drawingBy(const Method &method, Kernels kernels);
/// Draws with the oracle, under any rule.
void drawTruly(const Primitives &primitives, const ScanSettings &settings, FrameView frame);

/// The canvas of a case, with what was drawn on it. Its pixels have the case's own coordinates:
/// under the top-left rule y points down in the case and up in the kernels' frame, so the triangle
/// is drawn mirrored and read back mirrored.
class CasePicture {
public:
    CasePicture(const FrameSpec &canvas, FillRule rule);

    const FrameSpec &canvas() const { return m_canvas; }
    void draw(const Primitives &primitives, const ScanSettings &settings, const Drawing &drawing);
    void draw(const Triangle &triangle, const ScanSettings &settings, const Drawing &drawing);

    bool contains(std::int64_t x, std::int64_t y) const
    {
        return m_frame.view().contains(x, m_sign * y);
    }
    bool isWritten(std::int64_t x, std::int64_t y) const
    {
        return m_frame.isWritten(x, m_sign * y);
    }
    Colour colourAt(std::int64_t x, std::int64_t y) const
    {
        return m_frame.colourAt(x, m_sign * y);
    }

    /// Calls a function with x and y of every written pixel, column by column from the lowest y.
    template <class Function>
    void forEachWritten(const Function &function) const
    {
        for (std::int64_t x = m_canvas.firstColumn; x < m_frame.view().endColumn(); ++x) {
            for (std::int64_t row = 0; row < m_canvas.height; ++row) {
                if (isWritten(x, m_canvas.firstRow + row))
                    function(x, m_canvas.firstRow + row);
            }
        }
    }

    std::int64_t pixelCount() const;
    std::array<std::int64_t, 3> channelSums() const;
    /// The first 16 hexadecimal digits of the SHA-256 of "x lowest highest\n" for each column with
    /// pixels.
    QByteArray spanHash() const;
    /// Like spanHash(), of "x y
    /// " for each pixel, column by column from the lowest y.
    QByteArray pixelHash() const;
    /// Like pixelHash(), of "x y r g b
    /// ", with the bytes of the pixel's colour.
    QByteArray colourHash() const;

private:
    FrameSpec m_canvas; ///< in the case's coordinates
    std::int64_t m_sign = 1; ///< −1 where the case's y points down
    WrittenFrame m_frame;
};

/// Of two pictures of the same canvas.
DifferenceCounts differencesBetween(const CasePicture &drawn, const CasePicture &truth);

} // namespace pixelplumb
