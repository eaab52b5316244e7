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

/// Opens a scene that is in no file and goes to a pixel that differs from the truth when its run is
/// there.
class DifferenceOpening : public QObject {
    Q_OBJECT

public:
    DifferenceOpening(SceneFiles *files, Playhead *playhead, QObject *parent);

public slots:
    /// At the first pixel that differs.
    void open(const pixelplumb::Scene &scene);
    /// At this one. False when the person keeps the scene that is there.
    bool openAt(const pixelplumb::Scene &scene, const QPoint &pixel);

signals:
    void pixelReached(const QPoint &pixel); ///< the run stands there

private:
    void arrive();
    void standAt(const QPoint &pixel, const TracedScene &traced);
    void goToFirstDifference(const TracedScene &traced);

    SceneFiles *m_files;
    Playhead *m_playhead;
    std::optional<Scene> m_awaited; ///< its run is under way
    std::optional<QPoint> m_pixel; ///< where to go in it; none: to the first difference
};

} // namespace pixelplumb
