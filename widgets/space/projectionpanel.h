// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/job.h"
#include "widgets/space/sidescene.h"

#include <QtWidgets>

namespace pixelplumb {

class Playhead;
class SceneDocument;
class SideView;
class StageTree;
class SurfacesPanel;
struct TracedScene;

/// How the current triangle came from three dimensions to the frame: the camera from the side, and
/// every stage with its numbers; and, on a second tab, the forms of surfaces (objectName
/// "projectionPanel"). Follows the playhead; projects in a worker thread, and only while visible.
class ProjectionPanel : public QWidget {
    Q_OBJECT

public:
    ProjectionPanel(SceneDocument *document, Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {720, 480}; }

signals:
    /// The scene's solids are projected; the panel shows them.
    void projected();

private:
    struct Seen {
        ProjectedSolids projected;
        SideScene side;
    };

    void takeTraced();
    void take(const std::shared_ptr<const TracedScene> &traced, Seen seen);
    void followPosition();
    /// The index of the current triangle among the projected ones; none for a plain one.
    std::optional<std::size_t> currentTriangle() const;
    void showTriangle(std::size_t triangle);
    QString sceneSentence() const;
    QString triangleSentence(std::size_t triangle) const;
    void tell(const QString &text);

    Playhead *m_playhead;
    QLabel *m_sentence;
    QSplitter *m_parts;
    SideView *m_view;
    StageTree *m_stages;
    SurfacesPanel *m_surfaces;
    /// The run to which the next members belong; null while they are computed.
    std::shared_ptr<const TracedScene> m_seen;
    ProjectedSolids m_projected; ///< without triangles and attributes
    SideScene m_side;
    std::optional<std::size_t> m_shown; ///< the triangle whose stages are in the tree
    Job m_job;
};

} // namespace pixelplumb
