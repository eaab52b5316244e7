// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"
#include "core/layers/layermoment.h"
#include "widgets/canvas/canvasscene.h"

#include <QUndoCommand>

#include <optional>

namespace pixelplumb {

class DisplayOptions;

/// A move of the affine map's image that can be undone like any edit: the image requested before
/// and after. The scene stays as it is, so the document does not become modified.
class ImageEdit final : public QUndoCommand {
public:
    /// Edits of the same drag become one.
    ImageEdit(DisplayOptions &options, const std::optional<AffineImage> &after,
              const std::optional<int> &drag = std::nullopt);

    void redo() override;
    void undo() override;
    int id() const override { return m_drag ? 2 : -1; } // 1 is that of the scene's edits
    bool mergeWith(const QUndoCommand *other) override;

private:
    DisplayOptions *m_options;
    std::optional<AffineImage> m_before;
    std::optional<AffineImage> m_after;
    std::optional<int> m_drag;
};

/// Null while the run is not the scene's own, and while the truth is shown instead of the frame.
const TracedScene *runInView(const CanvasSources &sources);

/// The triangle's image under the affine map of the enabled layer; none where the layer draws none,
/// or one of a triangle without area.
std::optional<AffineImage> imageInView(const CanvasSources &sources);

/// The corner of that image under a position: 0, 1 or 2; of equally near ones the last.
std::optional<std::size_t> imageCornerAt(const QPointF &position, const CanvasSources &sources,
                                         const CanvasView &view);

/// Requests an image with one corner moved to the snapped target; beyond ±2^30 px nothing happens.
/// Moves with the same drag number are one edit.
void moveImageCorner(const CanvasSources &sources, AffineImage image, std::size_t corner,
                     const LatticePoint &target, int drag);

/// Keeps the requested image with its triangle, whose number edits change. The image of a triangle
/// that is hidden or removed comes back with it.
class ImageFollower : public QObject {
    Q_OBJECT

public:
    ImageFollower(const SceneDocument *document, DisplayOptions *options);

private:
    void remember();
    void followScene();

    const SceneDocument *m_document;
    DisplayOptions *m_options;
    std::size_t m_triangles = 0; ///< the scene's own, at the last change
    std::size_t m_solids = 0;
    std::optional<Triangle> m_triangle; ///< of the scene's own, whose image was requested last
    std::optional<Corners> m_gone; ///< its image, while it is not drawn
};

/// Adds the image's corners, in the colours of the vertices they are images of.
void addImageHandles(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view,
                     const CanvasHand &hand);

} // namespace pixelplumb
