// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QObject>
#include <QPoint>

#include <optional>

namespace pixelplumb {

class Playhead;
class SceneFiles;
struct TracedScene;

/// Opens a scene that is in no file and, once it is traced, moves to a pixel that differs from the
/// truth.
class DifferenceOpening : public QObject {
    Q_OBJECT

public:
    DifferenceOpening(SceneFiles *files, Playhead *playhead, QObject *parent);

public slots:
    /// Moves to the first pixel that differs.
    void open(const pixelplumb::Scene &scene);
    /// Moves to this pixel. False when the person keeps the current scene.
    bool openAt(const pixelplumb::Scene &scene, const QPoint &pixel);

signals:
    void pixelReached(const QPoint &pixel); ///< the playhead is there

private:
    void arrive();
    void standAt(const QPoint &pixel, const TracedScene &traced);
    void goToFirstDifference(const TracedScene &traced);

    SceneFiles *m_files;
    Playhead *m_playhead;
    std::optional<Scene> m_awaited; ///< being traced
    std::optional<QPoint> m_pixel; ///< to move to; none: the first difference
};

} // namespace pixelplumb
