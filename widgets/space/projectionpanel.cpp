// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/projectionpanel.h"

#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/space/sideview.h"
#include "widgets/space/stagetree.h"
#include "widgets/space/surfacespanel.h"

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

/// Why some are not drawn, "2 faces or triangles are not drawn: 1 lies …"; empty where all are.
QString lossesText(const std::vector<LostTriangle> &lost)
{
    std::map<ProjectionLoss, int> counts;
    for (const LostTriangle &each : lost)
        ++counts[each.loss];
    QStringList reasons;
    for (const auto &[loss, count] : counts)
        reasons += ProjectionPanel::tr("%1: each %2").arg(count).arg(coreWord(nameOf(loss)));
    if (reasons.isEmpty())
        return {};
    return ProjectionPanel::tr(" Not drawn are %1.").arg(reasons.join(u", "_s));
}

} // namespace

ProjectionPanel::ProjectionPanel(SceneDocument *document, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_sentence(readingLabel("projectionSentence", tr("The current triangle"), this))
    , m_parts(new QSplitter(Qt::Horizontal))
    , m_view(new SideView)
    , m_stages(new StageTree)
    , m_surfaces(new SurfacesPanel(document, playhead))
{
    named(this, "projectionPanel", tr("Projection"));
    m_parts->addWidget(m_view);
    m_parts->addWidget(m_stages);
    m_parts->setSizes({400, 500}); // used, exact and error side by side
    auto *projection = new QWidget;
    withParts(new QVBoxLayout(projection), {m_sentence, {m_parts, 1}}, 8, 8);
    auto *tabs = new QTabWidget;
    named(tabs, "projectionTabs", tr("Projection and surfaces"));
    tabs->setDocumentMode(true);
    tabs->addTab(projection, tr("Projection"));
    tabs->addTab(m_surfaces, tr("Surfaces"));
    withParts(new QVBoxLayout(this), {tabs}, -1, 0);
    onEvents(this, {QEvent::Show}, [this] {
        takeTraced();
        followPosition();
    });
    connect(playhead, &Playhead::tracedChanged, this, &ProjectionPanel::takeTraced);
    connect(playhead, &Playhead::positionChanged, this, &ProjectionPanel::followPosition);
    connect(playhead, &Playhead::pickedPixelChanged, this, &ProjectionPanel::followPosition);
}

void ProjectionPanel::takeTraced()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!isVisible() || (traced && traced == m_seen))
        return;
    m_job.cancel();
    m_seen.reset();
    const bool hasSolids = traced && !traced->scene.solids.empty();
    m_parts->setVisible(hasSolids);
    if (!hasSolids) {
        take(traced, {});
        return;
    }
    // Until this scene is projected, the members belong to another.
    m_job.start(
        [traced](const ProgressListener &listener) {
            auto projected = projectedSolids(traced->scene, listener);
            if (!projected)
                return Seen();
            Seen seen{std::move(*projected), sideSceneOf(traced->scene)};
            seen.projected.triangles = {};
            seen.projected.attributes = {};
            return seen;
        },
        [this, traced](Seen seen) { take(traced, std::move(seen)); });
}

void ProjectionPanel::take(const std::shared_ptr<const TracedScene> &traced, Seen seen)
{
    m_seen = traced;
    m_projected = std::move(seen.projected);
    m_side = std::move(seen.side);
    m_shown.reset();
    m_view->setScene(m_side);
    followPosition();
    emit projected();
}

std::optional<std::size_t> ProjectionPanel::currentTriangle() const
{
    const std::optional<TraceStep> step = m_playhead->currentStep();
    if (!m_seen || !step)
        return std::nullopt;
    const std::size_t first = m_seen->scene.triangles.size();
    if (step->primitive < first || step->primitive - first >= m_projected.sources.size())
        return std::nullopt;
    return step->primitive - first;
}

void ProjectionPanel::followPosition()
{
    if (!isVisible() || m_seen != m_playhead->sharedTraced())
        return;
    if (const auto triangle = currentTriangle()) {
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
    const Scene &scene = m_seen->scene;
    const FaceStages stages = stagesOf(scene, m_projected, triangle);
    m_view->setFace(sideFaceOf(scene, m_side, stages, m_projected.sources[triangle],
                               m_playhead->currentPixel()));
    if (m_shown != triangle)
        m_stages->setStages(stages.stages);
    m_shown = triangle;
}

QString ProjectionPanel::sceneSentence() const
{
    if (!m_seen)
        return tr("The scene is being drawn.");
    if (m_seen->scene.solids.empty()) {
        return tr("This scene has no solids. For a face of a sphere, a plane, a patch, a mesh or "
                  "a polygon in space, this panel shows how the camera takes it to the frame: "
                  "from its vertices to the eye's axes, clip coordinates, clipping at the near "
                  "plane, division by w, pixels and rounding to the lattice, with each number "
                  "beside its exact value.");
    }
    const QString triangles
        = tr("The scene's solids become %n triangles.", nullptr, int(m_projected.sources.size()));
    return triangles + lossesText(m_projected.lost) + tr(" Step into one of them.");
}

QString ProjectionPanel::triangleSentence(std::size_t triangle) const
{
    const Scene &scene = m_seen->scene;
    const TriangleSource &source = m_projected.sources[triangle];
    return tr("The current triangle is %1 %2 %3 of face %4 of solid %5, %6.")
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

} // namespace pixelplumb
