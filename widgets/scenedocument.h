// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QObject>
#include <QUndoStack>

#include <optional>

namespace pixelplumb {

/// What clicks and drags snap to: whole pixels, 1/16 px, or 1/256 px, the lattice itself.
enum class Snap { Pixel, Sixteenth, Finest };

/// The distance between its points, in lattice units.
Lattice stepOf(Snap snap);

/// A vertex of the document: of a triangle of the scene, or placed and waiting for its triangle.
struct VertexRef {
    static constexpr int pending = -1;
    int triangle = pending; ///< index, or `pending`
    int vertex = 0;

    friend bool operator==(const VertexRef &, const VertexRef &) = default;
};

/// The scene that a person edits, with the one or two vertices that wait for their triangle. Every
/// change is a command on the undo stack; the moves of one drag merge into one command.
/// Coordinates are the scene's own (see Scene).
class SceneDocument : public QObject {
    Q_OBJECT

public:
    explicit SceneDocument(QObject *parent = nullptr);
    ~SceneDocument() override;

    const Scene &scene() const { return m_scene; }
    const std::vector<Vertex> &pendingVertices() const { return m_pending; }
    QUndoStack *undoStack() { return &m_undoStack; }
    bool isModified() const { return !m_undoStack.isClean(); }

    Snap snap() const { return m_snap; }
    /// The colour that the next placed vertex gets: the one that the person chose for it, else red,
    /// green or blue in turn.
    Colour nextColour() const;
    std::optional<VertexRef> selectedVertex() const { return m_selected; }
    std::optional<Vertex> vertexAt(const VertexRef &ref) const;
    /// Every vertex: the triangles' in drawing order, then the pending ones.
    std::vector<VertexRef> vertices() const;
    LatticePoint snapped(const LatticePoint &point) const;

    /// Replaces everything and forgets the undo history; the document is unmodified after it.
    void reset(const Scene &scene);
    void markSaved() { m_undoStack.setClean(); }

    /// A number for the moves of one drag, or of one run of a key, that no other drag has.
    int newDrag() { return ++m_lastDrag; }

public slots:
    /// Every third vertex completes a triangle. Ignored with refused() beyond ±2^30 px.
    void placeVertex(const pixelplumb::LatticePoint &position);
    /// Moves that share a drag number are one command.
    void moveVertex(const pixelplumb::VertexRef &ref, const pixelplumb::LatticePoint &position,
                    int drag);
    void setVertexColour(const pixelplumb::VertexRef &ref, const pixelplumb::Colour &colour);
    void addTriangle(const pixelplumb::Triangle &triangle);
    void deleteTriangle(int triangle);
    /// Removes the triangle of a vertex, or the pending vertex.
    void deleteVertex(const pixelplumb::VertexRef &ref);
    void discardPending(); ///< all vertices that wait for their triangle
    void clear(); ///< all triangles and pending vertices
    void setFrame(const pixelplumb::FrameSpec &frame);
    void setSettings(const pixelplumb::ScanSettings &settings);
    void setMethod(const std::string &method);

    void setSnap(pixelplumb::Snap snap);
    void setNextColour(const pixelplumb::Colour &colour);
    void selectVertex(const std::optional<pixelplumb::VertexRef> &ref);

signals:
    void sceneChanged(); ///< triangles, frame, settings or method
    void pendingChanged();
    void selectionChanged();
    void snapChanged();
    void nextColourChanged();
    void modifiedChanged(bool modified);
    void refused(const QString &reason);

private:
    friend class SceneCommand;

    Vertex *find(const VertexRef &ref);
    bool accepts(const LatticePoint &position);
    void dropStaleSelection();

    Scene m_scene;
    std::vector<Vertex> m_pending;
    QUndoStack m_undoStack;
    Snap m_snap = Snap::Pixel;
    std::optional<Colour> m_chosenColour; ///< for the next vertex alone
    std::optional<VertexRef> m_selected;
    int m_lastDrag = 0;
};

} // namespace pixelplumb
