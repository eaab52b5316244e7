// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QObject>

#include <optional>

namespace pixelplumb {

class Playhead;
class SceneFiles;

/// Opens a hard case's scene and goes to the first pixel that differs from the truth when its run
/// is there.
class HardCasesOpening : public QObject {
    Q_OBJECT

public:
    HardCasesOpening(SceneFiles *files, Playhead *playhead, QObject *parent);

public slots:
    void open(const pixelplumb::Scene &scene);

private:
    void goToDifference();

    SceneFiles *m_files;
    Playhead *m_playhead;
    std::optional<Scene> m_awaited; ///< its run is under way
};

} // namespace pixelplumb
