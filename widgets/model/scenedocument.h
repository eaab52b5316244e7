// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/sceneedit.h"

#include <QtGui>

#include <functional>
#include <memory>
#include <optional>

namespace pixelplumb {

/// What clicks and drags snap to: whole pixels, 1/16 px, or 1/256 px, the lattice itself.
enum class Snap { Pixel, Sixteenth, Finest };

/// The distance between the snap points, in lattice units.
Lattice stepOf(Snap snap);

/// The scene that a person edits, with the vertices that await completion of their primitive. Every
/// change is an edit on the undo stack; the moves of one drag merge into one. The settings are
/// always supported by the method, so that what shows them shows what is drawn. Coordinates are the
/// scene's own (see Scene).
class SceneDocument : public QObject {
    Q_OBJECT

public:
    explicit SceneDocument(QObject *parent = nullptr);
    ~SceneDocument() override;

    /// As it is now: it does not follow edits.
    const Scene &scene() const { return *m_now.scene; }
    int hiddenCount() const { return int(scene().hidden.size()); } ///< without solids
    /// The scene for worker threads.
    const std::shared_ptr<const Scene> &snapshot() const { return m_now.scene; }
    /// The frame of the scene's motion that is shown, 0 … frames − 1; not saved.
    int currentFrame() const { return m_currentFrame; }
    /// The still scene at that frame; at frame 0 the snapshot itself.
    std::shared_ptr<const Scene> currentSnapshot() const;
    /// Maps a point of the scene to its place at that frame, and back.
    LatticePoint atCurrentFrame(const LatticePoint &point) const;
    LatticePoint fromCurrentFrame(const LatticePoint &place) const;
    const std::vector<Vertex> &pendingVertices() const { return m_now.pending; }
    QUndoStack *undoStack() { return &m_undoStack; }
    /// Whether closing would lose something: the primitives, settings or pending vertices differ
    /// from the saved ones. What was changed and changed back does not count, nor does another
    /// method, which only shows the same scene in another way.
    bool isModified() const;

    Snap snap() const { return m_snap; }
    /// What placed vertices become: the kind that the scene's method draws.
    PrimitiveKind placedKind() const;
    PrimitiveKind kindOf(int primitive) const;
    const Shape &shapeAt(int primitive) const; ///< for primitives that are not triangles
    /// The number of triangles and shapes; a solid's triangles do not count.
    int primitiveCount() const { return int(scene().triangles.size() + scene().shapes.size()); }
    /// The vertices of a primitive, by number.
    std::vector<Vertex> verticesOf(int primitive) const;
    /// Whether a primitive can be moved by `places` in the drawing order (earlier: negative):
    /// triangles are drawn before all shapes.
    bool canMovePrimitive(int primitive, int places) const;
    /// Whether the pending vertices could be closed to a polygon.
    bool canClosePending() const;
    /// The colour of the next placed vertex: the one chosen for it, else red, green or blue in
    /// turn.
    Colour nextColour() const;
    std::optional<VertexRef> selectedVertex() const { return m_selected; }
    std::optional<Vertex> vertexAt(const VertexRef &ref) const;
    /// The attributes of a triangle's vertices other than place and colour.
    TriangleAttributes attributesOf(int triangle) const;
    /// Every vertex: the primitives' in drawing order, then the pending ones.
    std::vector<VertexRef> vertices() const;
    LatticePoint snapped(const LatticePoint &point) const;
    /// The off-screen point, in the scene's coordinates; none where no rule asks for it.
    std::optional<LatticePoint> offScreenPoint() const;

    /// Replaces everything and clears the undo history; the document is then unmodified.
    void reset(Scene scene);
    void markSaved();
    void markUnsaved(); ///< no state of it counts as saved

    /// A drag number that no other drag or run of a key has.
    int newDrag() { return ++m_lastDrag; }

public slots:
    /// Places a vertex; the last one that the kind needs completes the primitive: every third a
    /// triangle. Beyond ±2^30 px it only emits refused().
    void placeVertex(const pixelplumb::LatticePoint &position);
    /// Moves with the same drag number are one edit.
    void moveVertex(const pixelplumb::VertexRef &ref, const pixelplumb::LatticePoint &position,
                    int drag);
    void setVertexColour(const pixelplumb::VertexRef &ref, const pixelplumb::Colour &colour);
    void setPrimitiveColour(int primitive, const pixelplumb::Colour &colour); ///< of all vertices
    /// Moves it in the drawing order; needs canMovePrimitive().
    void movePrimitive(int primitive, int places);
    /// The attributes' own index is ignored.
    void addTriangle(const pixelplumb::Triangle &triangle,
                     const pixelplumb::TriangleAttributes &attributes = {});
    void setTriangle(int primitive, const pixelplumb::Triangle &triangle,
                     const pixelplumb::TriangleAttributes &attributes);
    /// Makes a polygon of the pending vertices.
    void closePending();
    void setText(int primitive, const QString &text); ///< of a text
    /// Gives the vertices another form: of another kind, or filled otherwise.
    void setForm(int primitive, const Shape &shape);
    void deletePrimitive(int primitive);
    /// Removes it from the picture and from the numbering.
    void hidePrimitive(int primitive);
    /// Restores a hidden primitive to its place; `index` is its index among the hidden ones.
    void showHidden(int index);
    void showAllHidden();
    void deleteHidden(int index);
    /// Removes the primitive of a vertex, or the pending vertex.
    void deleteVertex(const pixelplumb::VertexRef &ref);
    void discardPending(); ///< all pending vertices
    void clear(); ///< all primitives, hidden ones too, solids and pending vertices
    void setFrame(const pixelplumb::FrameSpec &frame);
    /// Changes with the same drag number are one edit.
    void setSolid(std::size_t index, const pixelplumb::Solid &solid, int drag);
    void setSolidShown(std::size_t index, bool shown);
    bool canMoveSolid(std::size_t index, int places) const;
    /// Moves a solid by `places` in the drawing order among the solids.
    void moveSolid(std::size_t index, int places);
    void deleteSolid(std::size_t index);
    void setAppearance(const pixelplumb::Appearance &appearance);
    void setLook(const std::optional<pixelplumb::Camera> &camera,
                 const pixelplumb::Appearance &appearance);
    void setMotion(const std::optional<pixelplumb::Motion> &motion);
    /// Moves the point of the rule off-screen-point. Moves with the same drag number are one edit.
    void moveOffScreenPoint(const pixelplumb::LatticePoint &position, int drag);
    void setSettings(const pixelplumb::ScanSettings &settings);
    /// Pending vertices stay where the method draws the same kind of primitive.
    void setMethod(const std::string &method);

    /// Replaces the scene as one edit, which `text` names.
    void setScene(const pixelplumb::Scene &scene, const QString &text);

    void setSnap(pixelplumb::Snap snap);
    void setNextColour(const pixelplumb::Colour &colour);
    void selectVertex(const std::optional<pixelplumb::VertexRef> &ref);
    void setCurrentFrame(int frame); ///< clamped to the frames there are

signals:
    void opened(); ///< reset() has taken another scene
    void sceneChanged(); ///< primitives, frame, settings or method
    void currentFrameChanged(); ///< and the scene did not
    void pendingChanged();
    void selectionChanged();
    void snapChanged();
    void nextColourChanged();
    void modifiedChanged(bool modified);
    void refused(const QString &reason);
    /// Something else was changed besides what was asked for.
    void notice(const QString &text);
    /// Pending vertices were dropped because the new method draws another kind of primitive; undo
    /// restores them.
    void verticesDropped(const QString &text);

private:
    friend class SceneEdit;

    /// An edit of the document, unless `change` leaves it as it is.
    void edit(const QString &text, const std::function<void(DocumentState &)> &change,
              const std::optional<Drag> &drag = std::nullopt);
    void editScene(const QString &text, const std::function<void(Scene &)> &change,
                   const std::optional<Drag> &drag = std::nullopt);
    void changeShape(int primitive, const Shape &shape, const QString &text);
    void exchange(const DocumentState &before, const DocumentState &after);
    void tellModified();
    bool hasSavedScene() const;
    bool accepts(const LatticePoint &position);
    void followMotion();
    void tellSceneChanged();
    void tellAdaptation(const ScanSettings &asked);

    DocumentState m_now;
    int m_currentFrame = 0;
    LatticePoint m_way; ///< from frame 0 to the current frame
    QUndoStack m_undoStack;
    int m_lastNumber = 0; ///< of a state
    int m_savedNumber = 0;
    std::shared_ptr<const Scene> m_savedScene; ///< null: none counts as saved
    std::vector<Vertex> m_savedPending;
    bool m_toldModified = false;
    Snap m_snap = Snap::Pixel;
    std::optional<VertexRef> m_selected;
    int m_lastDrag = 0;
};

} // namespace pixelplumb
