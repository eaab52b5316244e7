// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/editmenu.h"

#include "widgets/canvas/canvas.h"
#include "widgets/dialogs/framedialog.h"
#include "widgets/dialogs/lookdialog.h"
#include "widgets/dialogs/triangledialog.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

namespace pixelplumb {

EditMenu::EditMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Edit"), window)
    , m_parts(parts)
{
    setObjectName(u"editMenu"_s);
    addUndo();
    addSeparator();
    addTools();
    addSeparator();
    addClipboard();
    addSeparator();
    addVertices(window);
    addSeparator();
    addFrameAndSnap(window);
}

void EditMenu::addUndo()
{
    QUndoStack *stack = m_parts.document->undoStack();
    QAction *undo = stack->createUndoAction(this, tr("&Undo"));
    undo->setObjectName(u"undo"_s);
    setListedText(undo, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    addAction(undo);
    QAction *redo = stack->createRedoAction(this, tr("&Redo"));
    redo->setObjectName(u"redo"_s);
    setListedText(redo, tr("&Redo"));
    redo->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
    addAction(redo);
}

void EditMenu::addTools()
{
    auto *group = new QActionGroup(this);
    Canvas *canvas = m_parts.canvas;
    const auto addTool = [&](const char *name, const QString &text, const QString &iconText,
                             const QString &tip, Qt::Key key, CanvasTool tool) {
        QAction *action = addSwitch(
            this, name, text, key, [canvas, tool] { canvas->setTool(tool); }, canvas,
            &Canvas::toolChanged, [canvas, tool] { return canvas->tool() == tool; });
        action->setIconText(iconText);
        action->setToolTip(tip);
        group->addAction(action);
        confineKeyTo(canvas, action);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut); // others may take it, too
        m_tools += action;
    };
    addTool("drawTool", tr("Dra&w"), tr("draw"),
            tr("A click places a vertex, a drag moves one (P)"), Qt::Key_P, CanvasTool::Draw);
    addTool("inspectTool", tr("&Inspect"), tr("inspect"),
            tr("A click picks the pixel and leaves the scene alone (V)"), Qt::Key_V,
            CanvasTool::Inspect);
}

void EditMenu::addClipboard()
{
    SceneExports *exports = m_parts.exports;
    QAction *copyPixel
        = addMenuAction(this, "copyPixel", tr("&Copy the picked pixel"), QKeySequence::Copy,
                        [exports] { exports->copyPickedPixel(); });
    confineKeyTo(m_parts.canvas, copyPixel);
    addMenuAction(this, "copyRaster", tr("Copy the raster (&ASCII)"),
                  Qt::CTRL | Qt::SHIFT | Qt::Key_C, [exports] { exports->copyRaster(); });
    MessageBar *bar = m_parts.messageBar;
    QAction *copyNote = addMenuAction(this, "copyNote", tr("Copy the last m&essage"), {},
                                      [bar] { QApplication::clipboard()->setText(bar->text()); });
    copyNote->setToolTip(tr("Copies the last note shown over the canvas, even after it has gone"));
    connect(this, &QMenu::aboutToShow, copyNote,
            [bar, copyNote] { copyNote->setEnabled(!bar->text().isEmpty()); });
    StudentPictureFiles *pictures = m_parts.pictures;
    QAction *paste
        = addMenuAction(this, "pasteStudentPicture", tr("&Paste a student's picture"), {},
                        [pictures] { pictures->take(*QApplication::clipboard()->mimeData()); });
    paste->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::Key_V), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V)});
    paste->setToolTip(
        tr("Marks on the canvas what differs in the clipboard's picture, or raster of "
           "“#” and “.” (Ctrl+V)"));
}

void EditMenu::addVertices(QWidget *window)
{
    SceneDocument *document = m_parts.document;
    addMenuAction(this, "addTriangle", tr("Add a &triangle…"), Qt::CTRL | Qt::Key_T,
                  [document, window] {
                      TriangleDialog dialog(window);
                      if (dialog.exec() != QDialog::Accepted)
                          return;
                      const TypedTriangle typed = *dialog.triangle();
                      document->addTriangle(typed.triangle, typed.attributes);
                  });
    QAction *change
        = addMenuAction(this, "editTriangle", tr("Chan&ge the current triangle…"),
                        Qt::CTRL | Qt::SHIFT | Qt::Key_T, [this, window] { editSelected(window); });
    QAction *close
        = addMenuAction(this, "closePolygon", tr("Close the pol&ygon"), Qt::CTRL | Qt::Key_Return,
                        [document] { document->closePending(); });
    keepUpdated(document, &SceneDocument::pendingChanged, close,
                [document, close] { close->setEnabled(document->canClosePending()); });
    addMenuAction(this, "nextVertexColour", tr("Colour of the &next vertex…"), {},
                  [this, window] { chooseNextColour(window); });
    QAction *colour = addMenuAction(this, "vertexColour", tr("Colour &of the selected vertex…"), {},
                                    [this, window] { chooseColourOfSelected(window); });
    QAction *remove = addMenuAction(this, "deleteSelected", tr("&Delete the selected primitive"),
                                    QKeySequence::Delete, [this] { deleteSelected(); });
    confineKeyTo(m_parts.canvas, remove);
    m_deletion = remove;
    QAction *hide = addMenuAction(this, "hideSelected", tr("&Hide the selected primitive"),
                                  Qt::CTRL | Qt::Key_H, [document] {
                                      if (const auto ref = document->selectedVertex())
                                          document->hidePrimitive(ref->primitive);
                                  });
    hide->setToolTip(tr("Keeps the primitive and does not draw it (the Primitives panel shows it "
                        "again)"));
    QAction *show = addMenuAction(this, "showAllHidden", tr("Show all hidden primiti&ves"),
                                  Qt::CTRL | Qt::SHIFT | Qt::Key_H,
                                  [document] { document->showAllHidden(); });
    change->setToolTip(tr("The triangle of the selected vertex; where none is selected, the one "
                          "that the current step draws"));
    keepUpdated(document, &SceneDocument::sceneChanged, this, [document, show, change] {
        show->setEnabled(document->scene().hiddenCount() > 0);
        change->setEnabled(!document->scene().triangles.empty());
    });
    keepUpdated(document, &SceneDocument::selectionChanged, this, [document, colour, remove, hide] {
        const std::optional<VertexRef> selected = document->selectedVertex();
        colour->setEnabled(selected.has_value());
        remove->setEnabled(selected.has_value());
        hide->setEnabled(selected && selected->primitive != VertexRef::pending);
    });
    addMenuAction(this, "clearScene", tr("C&lear all primitives"), {},
                  [document] { document->clear(); });
}

std::optional<int> EditMenu::currentTriangle() const
{
    const SceneDocument &document = *m_parts.document;
    const auto count = document.scene().triangles.size();
    const auto selected = document.selectedVertex();
    if (selected && selected->primitive != VertexRef::pending
        && std::size_t(selected->primitive) < count)
        return selected->primitive;
    const std::optional<TraceStep> step = m_parts.playhead->currentStep();
    const auto stepped = step ? m_parts.playhead->traced()->indexInScene(step->primitive)
                              : std::optional<std::size_t>();
    if (stepped && *stepped < count)
        return int(*stepped);
    return count > 0 ? std::optional(0) : std::nullopt;
}

void EditMenu::editSelected(QWidget *window)
{
    const std::optional<int> index = currentTriangle();
    if (!index)
        return;
    SceneDocument *document = m_parts.document;
    const Triangle shown = document->scene().triangles[std::size_t(*index)];
    TriangleDialog dialog({shown, document->attributesOf(*index)}, window);
    dialog.setWindowTitle(tr("Triangle %1").arg(*index));
    if (dialog.exec() != QDialog::Accepted)
        return;
    const TypedTriangle typed = *dialog.triangle();
    document->setTriangle(*index, typed.triangle, typed.attributes);
}

void EditMenu::addFrameAndSnap(QWidget *window)
{
    SceneDocument *document = m_parts.document;
    addMenuAction(this, "editFrame", tr("&Frame…"), Qt::CTRL | Qt::Key_F, [document, window] {
        FrameDialog dialog(document->scene().frame, window);
        if (dialog.exec() == QDialog::Accepted)
            document->setFrame(dialog.frame());
    });
    SceneFiles *files = m_parts.files;
    addMenuAction(this, "editLook", tr("Ca&mera, light and materials…"), Qt::CTRL | Qt::Key_L,
                  [document, files, window] {
                      const QString path = files->path();
                      const QString folder = path.isEmpty() ? path : QFileInfo(path).absolutePath();
                      LookDialog dialog(document->scene(), folder, window);
                      if (dialog.exec() == QDialog::Accepted)
                          document->setLook(dialog.look().camera, dialog.look().appearance);
                  });
    QMenu *snaps = addMenu(tr("&Snap to"));
    snaps->setObjectName(u"snapMenu"_s);
    auto *group = new QActionGroup(snaps);
    const auto addSnap = [&](const char *name, const QString &text, Snap snap) {
        group->addAction(addSwitch(
            snaps, name, text, {}, [document, snap] { document->setSnap(snap); }, document,
            &SceneDocument::snapChanged, [document, snap] { return document->snap() == snap; }));
    };
    addSnap("snapPixel", tr("whole &pixels"), Snap::Pixel);
    addSnap("snapSixteenth", tr("&sixteenths of a pixel"), Snap::Sixteenth);
    addSnap("snapLattice", tr("1/&256 pixel"), Snap::Finest);
}

void EditMenu::chooseColourOfSelected(QWidget *window)
{
    const std::optional<VertexRef> ref = m_parts.document->selectedVertex();
    const std::optional<Vertex> vertex = ref ? m_parts.document->vertexAt(*ref) : std::nullopt;
    if (!vertex)
        return;
    if (const auto colour = askForColour(vertex->colour, tr("Colour of the Vertex"), window))
        m_parts.document->setVertexColour(*ref, *colour);
}

void EditMenu::chooseNextColour(QWidget *window)
{
    SceneDocument *document = m_parts.document;
    if (const auto colour
        = askForColour(document->nextColour(), tr("Colour of the Next Vertex"), window))
        document->setNextColour(*colour);
}

void EditMenu::deleteSelected()
{
    if (const std::optional<VertexRef> ref = m_parts.document->selectedVertex())
        m_parts.document->deleteVertex(*ref);
}

} // namespace pixelplumb
