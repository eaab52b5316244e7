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

    void tellSceneChanged();
    void tellPendingChanged(); ///< and with it the next colour
    void tellSelectionChanged();
    /// For commands that remove vertices: forgets a selection that no longer names one.
    void dropStaleSelection() { m_document->dropStaleSelection(); }

private:
    SceneDocument *m_document;
};

/// The third vertex takes the two that wait and makes a triangle with them.
class PlaceVertexCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    PlaceVertexCommand(SceneDocument &document, const Vertex &vertex);
    void redo() override;
    void undo() override;

private:
    Vertex m_vertex;
    std::optional<Colour> m_chosenColour;
};

class MoveVertexCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    MoveVertexCommand(SceneDocument &document, const VertexRef &ref, const LatticePoint &position,
                      int drag);
    void redo() override { moveTo(m_after); }
    void undo() override { moveTo(m_before); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    void moveTo(const LatticePoint &position);

    VertexRef m_ref;
    LatticePoint m_before;
    LatticePoint m_after;
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

class DeleteTriangleCommand final : public SceneCommand {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::SceneDocument)

public:
    DeleteTriangleCommand(SceneDocument &document, int triangle);
    void redo() override;
    void undo() override;

private:
    int m_index;
    Triangle m_triangle;
};

/// Deleting one pending vertex, discarding all of them, and clearing the scene: the triangles and
/// the pending vertices of before are exchanged with those of after.
class ReplaceVerticesCommand final : public SceneCommand {
public:
    ReplaceVerticesCommand(SceneDocument &document, const QString &text,
                           std::vector<Triangle> triangles, std::vector<Vertex> pending);
    void redo() override { exchange(); }
    void undo() override { exchange(); }

private:
    void exchange();

    std::vector<Triangle> m_triangles;
    std::vector<Vertex> m_pending;
};

/// How the scene is drawn: its frame, its settings or its method.
class SetUpSceneCommand final : public SceneCommand {
public:
    /// Takes all but the triangles from `scene`.
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
