// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/renumbering.h"

#include <QObject>
#include <QUndoStack>

#include <memory>
#include <optional>

namespace pixelplumb {

/// What clicks and drags snap to: whole pixels, 1/16 px, or 1/256 px, the lattice itself.
enum class Snap { Pixel, Sixteenth, Finest };

/// The distance between its points, in lattice units.
Lattice stepOf(Snap snap);

/// The scene that a person edits, with the vertices that wait for their primitive. Every
/// change is an edit on the undo stack; the moves of one drag merge into one. The settings are
/// always such as the method keeps, so that all who show them show what is drawn. Coordinates are
/// the scene's own (see Scene).
class SceneDocument : public QObject {
    Q_OBJECT

public:
    explicit SceneDocument(QObject *parent = nullptr);
    ~SceneDocument() override;

    const Scene &scene() const { return m_scene; }
    int hiddenCount() const { return int(m_scene.hidden.size()); } ///< without solids
    /// The scene as it stands, for work beside the GUI thread. Made once a change, when asked for.
    std::shared_ptr<const Scene> snapshot() const;
    /// The frame of the scene's motion that is looked at, 0 … frames − 1; no part of what is saved.
    int frameInHand() const { return m_frameInHand; }
    /// The scene at that frame, where it stands; at frame 0 the snapshot itself.
    std::shared_ptr<const Scene> snapshotInHand() const;
    /// Where a point of the scene is at that frame, and of which point a place there is.
    LatticePoint atFrameInHand(const LatticePoint &point) const;
    LatticePoint fromFrameInHand(const LatticePoint &place) const;
    const std::vector<Vertex> &pendingVertices() const { return m_pending; }
    QUndoStack *undoStack() { return &m_undoStack; }
    /// Whether closing would lose something: the primitives, settings or waiting vertices are not
    /// those that were saved. Vertices that were discarded or undone leave nothing behind, and
    /// another method is another way to look at the same scene.
    bool isModified() const { return m_state != m_savedState || m_pending != m_savedPending; }

    Snap snap() const { return m_snap; }
    /// What placed vertices make: the kind that the scene's method draws.
    PrimitiveKind placedKind() const;
    PrimitiveKind kindOf(int primitive) const;
    const Shape &shapeAt(int primitive) const; ///< of what is no triangle
    /// Of the triangles and the shapes; a solid's triangles are none of the document's.
    int primitiveCount() const { return int(m_scene.triangles.size() + m_scene.shapes.size()); }
    /// The vertices of a primitive, by number.
    std::vector<Vertex> verticesOf(int primitive) const;
    /// Whether a primitive can be drawn that many places later (earlier: negative): triangles are
    /// drawn before all shapes.
    bool canMovePrimitive(int primitive, int places) const;
    /// Whether the pending vertices could be closed to a polygon.
    bool canClosePending() const;
    /// The colour that the next placed vertex gets: the one that the person chose for it, else red,
    /// green or blue in turn.
    Colour nextColour() const;
    std::optional<VertexRef> selectedVertex() const { return m_selected; }
    std::optional<Vertex> vertexAt(const VertexRef &ref) const;
    /// What a triangle's vertices carry beside place and colour.
    TriangleAttributes attributesOf(int triangle) const;
    /// Every vertex: the primitives' in drawing order, then the pending ones.
    std::vector<VertexRef> vertices() const;
    LatticePoint snapped(const LatticePoint &point) const;
    /// The off-screen point, in the scene's coordinates; none where no rule asks for it.
    std::optional<LatticePoint> offScreenPoint() const;

    /// Replaces everything and forgets the undo history; the document is unmodified after it.
    void reset(Scene scene);
    void markSaved();
    void markUnsaved(); ///< no state of it is in a file

    /// A number for the moves of one drag, or of one run of a key, that no other drag has.
    int newDrag() { return ++m_lastDrag; }

public slots:
    /// The last vertex that the kind needs completes the primitive: every third a triangle.
    /// Ignored with refused() beyond ±2^30 px.
    void placeVertex(const pixelplumb::LatticePoint &position);
    /// Moves that share a drag number are one edit.
    void moveVertex(const pixelplumb::VertexRef &ref, const pixelplumb::LatticePoint &position,
                    int drag);
    void setVertexColour(const pixelplumb::VertexRef &ref, const pixelplumb::Colour &colour);
    void setPrimitiveColour(int primitive, const pixelplumb::Colour &colour); ///< of all vertices
    /// In the drawing order: where canMovePrimitive().
    void movePrimitive(int primitive, int places);
    /// The attributes' own index says nothing here.
    void addTriangle(const pixelplumb::Triangle &triangle,
                     const pixelplumb::TriangleAttributes &attributes = {});
    void setTriangle(int primitive, const pixelplumb::Triangle &triangle,
                     const pixelplumb::TriangleAttributes &attributes);
    /// Makes a polygon of the pending vertices.
    void closePending();
    void setText(int primitive, const QString &text); ///< of a text
    /// The same vertices in another form: of another kind, or filled otherwise.
    void setForm(int primitive, const Shape &shape);
    void deletePrimitive(int primitive);
    /// Keeps it out of the picture, and out of the numbers of the others.
    void hidePrimitive(int primitive);
    /// Puts the hidden primitive, by its index among them, back into its place.
    void showHidden(int index);
    void showAllHidden();
    void deleteHidden(int index);
    /// Removes the primitive of a vertex, or the pending vertex.
    void deleteVertex(const pixelplumb::VertexRef &ref);
    void discardPending(); ///< all vertices that wait for their primitive
    void clear(); ///< all primitives, hidden ones too, solids and pending vertices
    void setFrame(const pixelplumb::FrameSpec &frame);
    /// Changes that share a drag number are one edit.
    void setCamera(const pixelplumb::Camera &camera, int drag);
    void setSolid(std::size_t index, const pixelplumb::Solid &solid, int drag);
    void setSolidShown(std::size_t index, bool shown);
    bool canMoveSolid(std::size_t index, int places) const;
    /// In the drawing order, by so many places among the solids.
    void moveSolid(std::size_t index, int places);
    void deleteSolid(std::size_t index);
    void setAppearance(const pixelplumb::Appearance &appearance);
    void setMotion(const std::optional<pixelplumb::Motion> &motion);
    /// Of the rule off-screen-point. Moves that share a drag number are one edit.
    void moveOffScreenPoint(const pixelplumb::LatticePoint &position, int drag);
    void setSettings(const pixelplumb::ScanSettings &settings);
    /// Waiting vertices stay where the method draws the same kind of primitive.
    void setMethod(const std::string &method);
    /// Another scene in place of this one, as one edit of that name.
    void setScene(const pixelplumb::Scene &scene, const QString &text);

    void setSnap(pixelplumb::Snap snap);
    void setNextColour(const pixelplumb::Colour &colour);
    void selectVertex(const std::optional<pixelplumb::VertexRef> &ref);
    void setFrameInHand(int frame); ///< the nearest that there is

signals:
    void opened(); ///< reset() has taken another scene
    /// An edit gives the triangles of the run, those of solids among them, these numbers.
    void trianglesRenumbered(const pixelplumb::TriangleRenumbering &numberAfter);
    void sceneChanged(); ///< primitives, frame, settings or method
    void frameInHandChanged(); ///< while the scene stays as it is
    void pendingChanged();
    void selectionChanged();
    void snapChanged();
    void nextColourChanged();
    void modifiedChanged(bool modified);
    void refused(const QString &reason);
    /// Something was changed beside what was asked for.
    void notice(const QString &text);
    /// Waiting vertices ended with the method for whose primitive they waited; undo brings them
    /// back.
    void verticesDropped(const QString &text);

private:
    friend class SceneEdit;

    /// What is small, and no primitive, one, or all.
    ScenePiece pieceAtEnd() const;
    ScenePiece pieceWith(int primitive) const; ///< or, where that is `pending`, none
    ScenePiece wholePiece() const;
    ScenePiece withPending(ScenePiece piece) const;
    void edit(const QString &text, const ScenePiece &before, const ScenePiece &after);
    /// `state`: what the scene's state is called after it.
    void exchange(const ScenePiece &before, const ScenePiece &after, int state);
    void tellRenumbering(const ScenePiece &before, const ScenePiece &after);
    void tellModified();
    bool accepts(const LatticePoint &position);
    void followMotion();
    void tellSceneChanged();
    void tellAdaptation(const ScanSettings &asked);

    Scene m_scene;
    mutable std::shared_ptr<const Scene> m_snapshot; ///< null until asked for after a change
    int m_frameInHand = 0;
    LatticePoint m_way; ///< from frame 0 to the frame in hand
    std::vector<Vertex> m_pending;
    QUndoStack m_undoStack;
    /// Numbers of the scene's states, waiting vertices apart: an edit of these alone keeps it.
    int m_state = 0;
    int m_lastState = 0;
    int m_savedState = 0;
    std::vector<Vertex> m_savedPending;
    bool m_toldModified = false;
    Snap m_snap = Snap::Pixel;
    std::optional<Colour> m_chosenColour; ///< for the next vertex alone
    std::optional<VertexRef> m_selected;
    int m_lastDrag = 0;
};

} // namespace pixelplumb
