// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/space/sidescene.h"

#include <QWidget>

class QLabel;
class QSplitter;

namespace pixelplumb {

class Playhead;
class SideView;
class StageTree;
class SurfacesPanel;

/// How the triangle in hand came from three dimensions to the frame: the camera from the side, and
/// every stage with its numbers; and, on a second tab, the forms of surfaces (objectName
/// "projectionPanel"). Follows the playhead, and computes only while it is seen.
class ProjectionPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProjectionPanel(Playhead *playhead, QWidget *parent = nullptr);
    ~ProjectionPanel() override;

    QSize sizeHint() const override { return {720, 360}; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void takeTraced();
    void followPosition();
    /// The index among the projected triangles of the triangle in hand; none of a plain one.
    std::optional<std::size_t> triangleInHand() const;
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
    bool m_isStale = true;
    ProjectedSolids m_projected; ///< of the playhead's scene, without triangles and attributes
    SideScene m_side;
    std::optional<std::size_t> m_shown; ///< the triangle whose stages stand in the tree
};

} // namespace pixelplumb
