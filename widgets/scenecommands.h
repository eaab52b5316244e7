// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/scenedocument.h"

#include <QCoreApplication>
#include <QUndoCommand>

namespace pixelplumb {

/// A change of a SceneDocument that knows its way back. The base alone reaches into the document;
/// commands change it through what the base offers and say what they changed.
class SceneCommand : public QUndoCommand {
protected:
    SceneCommand(SceneDocument &document, const QString &text)
        : QUndoCommand(text)
        , m_document(&document)
    {
    }

    Scene &scene() { return m_document->m_scene; }
    std::vector<Vertex> &pending() { return m_document->m_pending; }
    std::optional<Colour> &chosenColour() { return m_document->m_chosenColour; }
    std::optional<VertexRef> &selected() { return m_document->m_selected; }
    Vertex &vertex(const VertexRef &ref) { return *m_document->find(ref); }
    /// Null where the primitive is a triangle.
    Shape *shape(int primitive) { return m_document->findShape(primitive); }
    PrimitiveKind placedKind() const { return m_document->placedKind(); }
    /// Puts a primitive made of the pending vertices into the scene, or takes the last one of its
    /// kind out and makes its vertices pending again. A selection goes with its vertex.
    void completePending();
    void reopenLast(PrimitiveKind kind);
    /// Names the selected vertex anew where a primitive comes in or goes out at an index.
    void shiftSelection(int index, int by);

    void tellSceneChanged();
    void tellPendingChanged(); ///< and with it the next colour
    void tellSelectionChanged();
    /// For commands that remove vertices: forgets a selection that no longer names one.
    void dropStaleSelection() { m_document->dropStaleSelection(); }

private:
    SceneDocument *m_document;
};

/// The last vertex that a primitive needs takes those that wait and makes it with them.
class PlaceVertexCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    PlaceVertexCommand(SceneDocument &document, const Vertex &vertex);
    void redo() override;
    void undo() override;

private:
    Vertex m_vertex;
    PrimitiveKind m_kind;
    std::optional<Colour> m_chosenColour;
    std::vector<Vertex> m_waiting; ///< as they were before they became a shape
};

/// The pending vertices become a polygon.
class ClosePolygonCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    explicit ClosePolygonCommand(SceneDocument &document);
    void redo() override;
    void undo() override;
};

class SetTextCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    SetTextCommand(SceneDocument &document, int primitive, const std::string &text);
    void redo() override { exchange(); }
    void undo() override { exchange(); }

private:
    void exchange();

    int m_primitive;
    std::string m_text;
};

class MoveVertexCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    MoveVertexCommand(SceneDocument &document, const VertexRef &ref, const LatticePoint &position,
                      int drag);
    void redo() override;
    void undo() override;
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    void tell();

    VertexRef m_ref;
    LatticePoint m_before;
    LatticePoint m_after;
    std::optional<Shape> m_shapeBefore; ///< whose other vertices may move too
    int m_drag;
};

class SetVertexColourCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    SetVertexColourCommand(SceneDocument &document, const VertexRef &ref, const Colour &colour);
    void redo() override { exchange(); }
    void undo() override { exchange(); }

private:
    void exchange();

    VertexRef m_ref;
    Colour m_colour;
};

class InsertTriangleCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    InsertTriangleCommand(SceneDocument &document, const Triangle &triangle);
    void redo() override;
    void undo() override;

private:
    Triangle m_triangle;
};

class DeletePrimitiveCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    DeletePrimitiveCommand(SceneDocument &document, int primitive);
    void redo() override;
    void undo() override;

private:
    int m_index;
    Triangle m_triangle;
    std::optional<Shape> m_shape; ///< in the triangle's stead
    std::vector<TriangleAttributes> m_attributes; ///< those of the other state
};

/// Deleting one pending vertex, discarding all of them, and clearing the scene: the primitives and
/// the pending vertices of before are exchanged with those of after.
class ReplaceVerticesCommand final : public SceneCommand {
public:
    ReplaceVerticesCommand(SceneDocument &document, const QString &text, Primitives primitives,
                           std::vector<Vertex> pending);
    void redo() override { exchange(); }
    void undo() override { exchange(); }

private:
    void exchange();

    Primitives m_primitives;
    std::vector<Vertex> m_pending;
};

/// How the scene is drawn: its frame, its settings or its method.
class SetUpSceneCommand final : public SceneCommand {
public:
    /// Takes all but the primitives from `scene`.
    SetUpSceneCommand(SceneDocument &document, const QString &text, const Scene &scene);
    void redo() override { exchange(); }
    void undo() override { exchange(); }

private:
    void exchange();

    FrameSpec m_frame;
    ScanSettings m_settings;
    std::string m_method;
};

} // namespace pixelplumb
