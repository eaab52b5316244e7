// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/overdraw.h"

#include <QtWidgets>

namespace pixelplumb {

class Canvas;
class Playhead;

/// Shows over the canvas, in its mapping, how often primitives write each pixel of the finished
/// run, by shades and digits, and the gaps that none writes. Lets the mouse through.
class OverdrawOverlay : public QWidget {
    Q_OBJECT

public:
    OverdrawOverlay(Canvas *canvas, Playhead *playhead);

    const OverdrawMap &map() const { return m_map; }
    /// "13 pixels twice or more, 4 at most; 63 gaps"
    QString summary() const;

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void followTrace();
    QRgb shadeOf(std::int64_t x, std::int64_t y) const;
    void makeShades();

    Canvas *m_canvas;
    Playhead *m_playhead;
    OverdrawMap m_map;
    std::shared_ptr<const TracedScene> m_counted; ///< the run that the map counts
    QImage m_shades; ///< one pixel per frame pixel
    QImage m_cells; ///< the visible cells in device pixels
};

} // namespace pixelplumb
