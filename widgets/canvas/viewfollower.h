// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>

#include <optional>

namespace pixelplumb {

class CanvasMouse;
class CanvasView;
class Playhead;
struct TracedScene;

/// Moves the canvas's view when a step, a choice or a run leads to a pixel outside it. The run of
/// an edited scene does not move the view under the pointer.
class ViewFollower : public QObject {
    Q_OBJECT

public:
    ViewFollower(CanvasView &view, const CanvasMouse &mouse, const Playhead *playhead);

private:
    /// What a person looks at.
    struct Moment {
        const TracedScene *traced = nullptr;
        std::size_t position = 0;
        std::optional<QPoint> picked;

        bool operator==(const Moment &) const = default;
    };

    void follow();
    std::optional<QPoint> pixelSince(const Moment &before) const;

    CanvasView &m_view;
    const CanvasMouse &m_mouse;
    const Playhead *m_playhead;
    Moment m_moment;
};

} // namespace pixelplumb
