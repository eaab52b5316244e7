// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/projectionpanel.h"

#include "widgets/model/playhead.h"
#include "widgets/space/sideview.h"
#include "widgets/space/stagetree.h"
#include "widgets/space/surfacespanel.h"

#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include <map>

namespace pixelplumb {

namespace {

QString kindName(SolidKind kind)
{
    switch (kind) {
    case SolidKind::Triangle3:
        return ProjectionPanel::tr("a triangle");
    case SolidKind::Polygon3:
        return ProjectionPanel::tr("a polygon");
    case SolidKind::Plane:
        return ProjectionPanel::tr("a plane");
    case SolidKind::Sphere:
        return ProjectionPanel::tr("a sphere");
    case SolidKind::Patch:
        return ProjectionPanel::tr("a patch");
    case SolidKind::Mesh:
        return ProjectionPanel::tr("a mesh");
    }
    return {};
}

/// "2 faces or triangles are not drawn: 1 lies …": empty where all are.
QString lossesText(const std::vector<LostTriangle> &lost)
{
    std::map<ProjectionLoss, int> counts;
    for (const LostTriangle &each : lost)
        ++counts[each.loss];
    QStringList reasons;
    for (const auto &[loss, count] : counts)
        reasons += ProjectionPanel::tr("%1: each %2").arg(count).arg(nameOf(loss));
    if (reasons.isEmpty())
        return {};
    return ProjectionPanel::tr(" Not drawn are %1.").arg(reasons.join(QStringLiteral(", ")));
}

} // namespace

ProjectionPanel::ProjectionPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_sentence(new QLabel)
    , m_parts(new QSplitter(Qt::Horizontal))
    , m_view(new SideView)
    , m_stages(new StageTree)
    , m_surfaces(new SurfacesPanel(playhead))
{
    setObjectName(QStringLiteral("projectionPanel"));
    setAccessibleName(tr("Projection"));
    m_sentence->setObjectName(QStringLiteral("projectionSentence"));
    m_sentence->setAccessibleName(tr("The triangle in hand"));
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_parts->addWidget(m_view);
    m_parts->addWidget(m_stages);
    m_parts->setStretchFactor(0, 1);
    m_parts->setStretchFactor(1, 1);
    auto *projection = new QWidget;
    auto *column = new QVBoxLayout(projection);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_sentence);
    column->addWidget(m_parts, 1);
    column->addStretch(0);
    auto *tabs = new QTabWidget;
    tabs->setObjectName(QStringLiteral("projectionTabs"));
    tabs->setDocumentMode(true);
    tabs->addTab(projection, tr("Projection"));
    tabs->addTab(m_surfaces, tr("Surfaces"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(tabs);
    const auto forget = [this] {
        m_isStale = true;
        takeTraced();
    };
    connect(playhead, &Playhead::tracedChanged, this, forget);
    connect(playhead, &Playhead::positionChanged, this, &ProjectionPanel::followPosition);
    connect(playhead, &Playhead::pickedPixelChanged, this, &ProjectionPanel::followPosition);
    takeTraced();
}

ProjectionPanel::~ProjectionPanel() = default;

void ProjectionPanel::takeTraced()
{
    if (!isVisible() || !m_isStale)
        return;
    m_projected = {};
    m_shown.reset();
    const TracedScene *traced = m_playhead->traced();
    m_isStale = false;
    const bool hasSolids = traced && !traced->scene.solids.empty();
    m_parts->setVisible(hasSolids);
    m_stages->setStages({});
    if (hasSolids) {
        m_projected = projectedSolids(traced->scene);
        m_projected.triangles = {};
        m_projected.attributes = {};
        m_side = sideSceneOf(traced->scene);
        m_view->setScene(m_side);
    } else {
        m_view->setScene({});
    }
    followPosition();
}

std::optional<std::size_t> ProjectionPanel::triangleInHand() const
{
    const TracedScene *traced = m_playhead->traced();
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    if (!traced || !step)
        return std::nullopt;
    const std::size_t first = traced->scene.triangles.size();
    if (step->primitive < first || step->primitive - first >= m_projected.sources.size())
        return std::nullopt;
    return step->primitive - first;
}

void ProjectionPanel::followPosition()
{
    if (!isVisible() || m_isStale)
        return;
    if (const auto triangle = triangleInHand()) {
        showTriangle(*triangle);
        tell(triangleSentence(*triangle));
        return;
    }
    m_shown.reset();
    m_stages->setStages({});
    m_view->setFace({});
    tell(sceneSentence());
}

void ProjectionPanel::showTriangle(std::size_t triangle)
{
    const Scene &scene = m_playhead->traced()->scene;
    const FaceStages stages = stagesOf(scene, m_projected, triangle);
    m_view->setFace(sideFaceOf(scene, m_side, stages, m_projected.sources[triangle],
                               m_playhead->pixelInHand()));
    if (m_shown != triangle)
        m_stages->setStages(stages.stages);
    m_shown = triangle;
}

QString ProjectionPanel::sceneSentence() const
{
    const TracedScene *traced = m_playhead->traced();
    if (!traced)
        return tr("The scene is being drawn.");
    if (traced->scene.solids.empty()) {
        return tr("This scene has no solids. Of a face of a sphere, a plane, a patch, a mesh or a "
                  "polygon in space, here stands how the camera takes it to the frame: from its "
                  "vertices to the eye's axes, clip coordinates, the polygon that the near plane "
                  "leaves, the division by w, pixels and the lattice, each number beside the "
                  "exact one.");
    }
    const QString triangles
        = tr("The scene's solids become %n triangle(s).", "", int(m_projected.sources.size()));
    return triangles + lossesText(m_projected.lost) + tr(" Step into one of them.");
}

QString ProjectionPanel::triangleSentence(std::size_t triangle) const
{
    const Scene &scene = m_playhead->traced()->scene;
    const TriangleSource &source = m_projected.sources[triangle];
    return tr("The triangle in hand is %1 %2 %3 of face %4 of solid %5, %6.")
               .arg(clippedCornerName(0), clippedCornerName(source.piece + 1),
                    clippedCornerName(source.piece + 2))
               .arg(source.face)
               .arg(source.solid)
               .arg(kindName(scene.solids[source.solid].kind))
        + lossesText(m_projected.lost);
}

void ProjectionPanel::tell(const QString &text)
{
    m_sentence->setText(text);
    setAccessibleDescription(text);
}

void ProjectionPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    takeTraced();
    followPosition();
}

} // namespace pixelplumb
