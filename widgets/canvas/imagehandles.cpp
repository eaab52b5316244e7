// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/imagehandles.h"

#include "core/layers/affinemap.h"
#include "core/layers/layer.h"
#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

HandleState stateOf(std::size_t corner, const CanvasHand &hand)
{
    if (corner == hand.chosenCorner)
        return HandleState::Selected;
    return corner == hand.hoveredCorner ? HandleState::Hovered : HandleState::Idle;
}

} // namespace

ImageEdit::ImageEdit(DisplayOptions &options, const std::optional<AffineImage> &after,
                     const std::optional<int> &drag)
    : QUndoCommand(QCoreApplication::translate("pixelplumb::Canvas", "move image"))
    , m_options(&options)
    , m_before(options.affineImage())
    , m_after(after)
    , m_drag(drag)
{
}

void ImageEdit::redo() { m_options->setAffineImage(m_after); }

void ImageEdit::undo() { m_options->setAffineImage(m_before); }

bool ImageEdit::mergeWith(const QUndoCommand *other)
{
    const auto &edit = static_cast<const ImageEdit &>(*other); // the ids are equal
    if (edit.m_drag != m_drag)
        return false;
    m_after = edit.m_after;
    setObsolete(m_after == m_before); // a drag that came back changed nothing
    return true;
}

const TracedScene *runInView(const CanvasSources &sources)
{
    const bool isAhead = sources.previewer && sources.previewer->isAheadOfTrace();
    const bool isTruth = sources.options->isTruthShown() && !sources.playhead->isAheadHidden();
    return isAhead || isTruth ? nullptr : tracedOfFrame(*sources.document, *sources.playhead);
}

std::optional<AffineImage> imageInView(const CanvasSources &sources)
{
    const QString id = u"affine-map"_s;
    if (!sources.options->layers().contains(id))
        return std::nullopt;
    const Layer &layer = *layerNamed(id);
    const TracedScene *traced = runInView(sources);
    if (!traced || !layer.objection(traced->scene).isEmpty())
        return std::nullopt;
    LayerView view;
    view.traced = traced;
    view.position = sources.playhead->position();
    view.image = sources.options->affineImage();
    const std::optional<std::size_t> triangle = subjectOf(layer, view);
    if (!triangle || doubledArea(traced->primitives.triangles[*triangle]) == 0)
        return std::nullopt;
    return AffineImage{*triangle, imagesOf(view, *triangle)};
}

std::optional<std::size_t> imageCornerAt(const QPointF &position, const CanvasSources &sources,
                                         const CanvasView &view)
{
    const std::optional<AffineImage> image = imageInView(sources);
    std::optional<std::size_t> nearest;
    double least = handleHitRadius;
    for (std::size_t i = 0; image && view.area().contains(position) && i < 3; ++i) {
        const QPointF way = view.positionOf(image->corners[i]) - position;
        const double distance = std::hypot(way.x(), way.y());
        if (distance > least)
            continue;
        nearest = i;
        least = distance;
    }
    return nearest;
}

void moveImageCorner(const CanvasSources &sources, AffineImage image, std::size_t corner,
                     const LatticePoint &target, int drag)
{
    image.corners[corner] = sources.document->snapped(target);
    if (isWithinRange(image.corners[corner]) && sources.options->affineImage() != image)
        sources.document->undoStack()->push(new ImageEdit(*sources.options, image, drag));
}

ImageFollower::ImageFollower(const SceneDocument *document, DisplayOptions *options)
    : m_document(document)
    , m_options(options)
{
    connect(options, &DisplayOptions::changed, this, &ImageFollower::remember);
    connect(document, &SceneDocument::sceneChanged, this, &ImageFollower::followScene);
    connect(document, &SceneDocument::opened, this, [this] {
        m_triangle.reset();
        m_gone.reset();
    });
    followScene();
}

void ImageFollower::remember()
{
    const std::optional<AffineImage> &asked = m_options->affineImage();
    if (!asked)
        return;
    const std::vector<Triangle> &triangles = m_document->scene().triangles;
    m_gone.reset();
    m_triangle = asked->triangle < triangles.size() ? std::optional(triangles[asked->triangle])
                                                    : std::nullopt;
}

void ImageFollower::followScene()
{
    const std::vector<Triangle> &triangles = m_document->scene().triangles;
    const std::size_t before = std::exchange(m_triangles, triangles.size());
    const std::size_t solids = m_document->scene().solids.size();
    const bool keepsSolids = std::exchange(m_solids, solids) == solids;
    const std::optional<AffineImage> asked = m_options->affineImage();
    if (asked && m_triangle && asked->triangle < triangles.size()
        && triangles[asked->triangle] == *m_triangle)
        return;
    const bool isOfSolid = asked && asked->triangle >= before;
    const auto found = m_triangle ? std::ranges::find(triangles, *m_triangle) : triangles.end();
    const bool isThere = found != triangles.end();
    const auto place = std::size_t(found - triangles.begin());
    if (isOfSolid && keepsSolids) // after the scene's own triangles
        m_options->setAffineImage(
            AffineImage{asked->triangle - before + triangles.size(), asked->corners});
    else if (isThere && asked)
        m_options->setAffineImage(AffineImage{place, asked->corners});
    else if (isThere && m_gone)
        m_options->setAffineImage(AffineImage{place, *std::exchange(m_gone, std::nullopt)});
    else if (asked && !isOfSolid && triangles.size() == before)
        remember(); // the triangle itself was changed
    else if (asked) {
        m_gone = asked->corners;
        m_options->setAffineImage(std::nullopt);
    }
}

void addImageHandles(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view,
                     const CanvasHand &hand)
{
    const std::optional<AffineImage> image = imageInView(sources);
    if (!image)
        return;
    const Triangle &triangle = sources.playhead->traced()->primitives.triangles[image->triangle];
    for (std::size_t i = 0; i < 3; ++i)
        scene.handles.push_back(
            {view.onSamples(image->corners[i]), triangle.vertices[i].colour, stateOf(i, hand)});
}

} // namespace pixelplumb
