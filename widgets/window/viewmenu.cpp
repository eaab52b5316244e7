// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/viewmenu.h"

#include "widgets/canvas/canvas.h"
#include "widgets/canvas/overdrawoverlay.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/paletteswitch.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"
#include "widgets/window/windowdocks.h"
#include "widgets/window/workspaces.h"

#include <QActionGroup>

namespace pixelplumb {

namespace {

/// Adds an entry to an exclusive group; the switch's current choice is checked.
void addChoice(QActionGroup *group, QMenu *menu, const char *name, const QString &text,
               PaletteSwitch *palettes, PaletteChoice choice)
{
    group->addAction(addSwitch(
        menu, name, text, {}, [palettes, choice] { palettes->choose(choice); }, palettes,
        &PaletteSwitch::changed, [palettes, choice] { return palettes->choice() == choice; }));
}

} // namespace

ViewMenu::ViewMenu(const WindowParts &parts, WindowDocks *docks, PaletteSwitch *palettes,
                   QWidget *window)
    : QMenu(tr("&View"), window)
{
    setObjectName(u"viewMenu"_s);
    addOptions(parts);
    addSeparator();
    addZoom(parts.canvas);
    addSeparator();
    addWorkspaces(docks->workspaces());
    addDocks(parts, docks);
    addSeparator();
    addPalettes(palettes);
}

void ViewMenu::addOptions(const WindowParts &parts)
{
    DisplayOptions *options = parts.options;
    const auto addOption = [&](const char *name, const QString &text, const QString &iconText,
                               const QString &tip, Qt::Key key, auto isShown, auto setShown) {
        QAction *action = addSwitch(
            this, name, text, key, [options, setShown](bool shown) { (options->*setShown)(shown); },
            options, &DisplayOptions::changed,
            [options, isShown] { return (options->*isShown)(); });
        action->setIconText(iconText);
        action->setToolTip(tip);
        confineKeyTo(parts.canvas, action);
        return action;
    };
    m_grid = addOption("showGrid", tr("&Grid"), tr("grid"), tr("Lines between the pixels (G)"),
                       Qt::Key_G, &DisplayOptions::isGridShown, &DisplayOptions::setGridShown);
    m_truth = addOption("showTruth", tr("T&ruth"), tr("truth"),
                        tr("The exact finished picture instead of the frame (R)"), Qt::Key_R,
                        &DisplayOptions::isTruthShown, &DisplayOptions::setTruthShown);
    m_differences = addOption("showDifferences", tr("&Differences"), tr("differences"),
                              tr("Mark pixels that differ from the truth, or in the student's "
                                 "picture: ? missing, ! extra, c colour (D)"),
                              Qt::Key_D, &DisplayOptions::areDifferencesShown,
                              &DisplayOptions::setDifferencesShown);
    QAction *student = addOption(
        "showStudent", tr("Stude&nt's picture"), tr("student"),
        tr("The student's picture instead of the frame; while Shift is held, the expected one (S)"),
        Qt::Key_S, &DisplayOptions::isStudentShown, &DisplayOptions::setStudentShown);
    keepUpdated(parts.student, &StudentPicture::judged, student,
                [student, picture = parts.student] {
                    student->setEnabled(picture->judgement() != nullptr);
                });
    const QString clippingTip = tr("The current triangle's face as clipped by the near plane, and "
                                   "the triangles that it is drawn as (N)");
    QAction *clipping
        = addOption("showClipping", tr("&Clipped polygon"), tr("clipped"), clippingTip, Qt::Key_N,
                    &DisplayOptions::isClippingShown, &DisplayOptions::setClippingShown);
    const auto tell = [document = parts.document, clipping, clippingTip] {
        const bool hasSolids = !document->scene().solids.empty();
        clipping->setEnabled(hasSolids);
        clipping->setToolTip(hasSolids
                                 ? clippingTip
                                 : tr("Nothing to show: the scene has no solid, so the near plane "
                                      "clips nothing."));
    };
    keepUpdated(parts.document, &SceneDocument::sceneChanged, clipping, tell);
    addOption(
        "showHexadecimal", tr("Values in &hexadecimal"), tr("hexadecimal"),
        tr("The bytes in large cells and in the pixel grid as 00 … ff instead of 0 … 255 (X)"),
        Qt::Key_X, &DisplayOptions::isHexadecimal, &DisplayOptions::setHexadecimal);
    OverdrawOverlay *overdraw = parts.overdraw;
    QAction *counts = addMenuAction(this, "showOverdraw", tr("&Overdraw and gaps"), Qt::Key_O,
                                    [overdraw](bool shown) { overdraw->setVisible(shown); });
    counts->setCheckable(true);
    counts->setToolTip(
        tr("How often each pixel is written, and the gaps that are never written (O)"));
    confineKeyTo(parts.canvas, counts);
}

void ViewMenu::addZoom(Canvas *canvas)
{
    QAction *in = addMenuAction(this, "zoomIn", tr("Zoom &in"), {}, [canvas] { canvas->zoomIn(); });
    in->setShortcuts({Qt::CTRL | Qt::Key_Plus, Qt::CTRL | Qt::Key_Equal});
    addMenuAction(this, "zoomOut", tr("Zoom &out"), Qt::CTRL | Qt::Key_Minus,
                  [canvas] { canvas->zoomOut(); });
    addMenuAction(this, "zoomToFit", tr("&Fit the frame"), Qt::CTRL | Qt::Key_0,
                  [canvas] { canvas->fitToView(); });
    addMenuAction(this, "zoomToOne", tr("One &to one"), Qt::CTRL | Qt::ALT | Qt::Key_0,
                  [canvas] { canvas->setZoom(1); });
}

void ViewMenu::addWorkspaces(Workspaces *workspaces)
{
    QMenu *menu = addMenu(tr("&Workspace"));
    menu->setObjectName(u"workspaceMenu"_s);
    auto *group = new QActionGroup(menu);
    const auto add = [&](const char *name, Workspace workspace, const QString &tip) {
        const QKeyCombination key(Qt::ControlModifier, Qt::Key(Qt::Key_1 + m_workspaces.size()));
        QAction *action = addMenuAction(menu, name, titleOf(workspace), key,
                                        [=] { workspaces->goTo(workspace); });
        action->setCheckable(true);
        action->setToolTip(tipWithKey(tip, key));
        group->addAction(action);
        m_workspaces += action;
    };
    add("stepWorkspace", Workspace::Step, tr("Step through a run, with all its numbers"));
    add("compareWorkspace", Workspace::Compare,
        tr("Compare methods with each other and the truth"));
    add("measureWorkspace", Workspace::Measure, tr("Measure what accuracy costs"));
    add("gradeWorkspace", Workspace::Grade, tr("Grade students' pictures"));
    menu->addSeparator();
    QAction *back = addMenuAction(menu, "workspaceBack", tr("&Back"), Qt::ALT | Qt::Key_Left,
                                  [workspaces] { workspaces->goBack(); });
    menu->addSeparator();
    addMenuAction(menu, "resetLayout", tr("&Reset this workspace"), {},
                  [workspaces] { workspaces->reset(); });
    keepUpdated(workspaces, &Workspaces::changed, this, [this, workspaces, back] {
        m_workspaces[int(workspaces->current())]->setChecked(true);
        back->setEnabled(workspaces->canGoBack());
    });
}

void ViewMenu::addDocks(const WindowParts &parts, WindowDocks *docks)
{
    QAction *inspect = addMenuAction(this, "inspect", tr("In&spector (pixel grid)"), Qt::Key_Z,
                                     [docks] { docks->raise<PixelGrid>()->setFocus(); });
    confineKeyTo(parts.canvas, inspect);
    QMenu *panels = addMenu(tr("&Panels"));
    panels->setObjectName(u"panelsMenu"_s);
    constexpr int digits = 10;
    int row = 0;
    for (QAction *toggle : docks->toggles()) {
        const Qt::KeyboardModifiers modifiers
            = row < digits ? Qt::AltModifier : Qt::AltModifier | Qt::ShiftModifier;
        toggle->setShortcut(QKeyCombination(modifiers, Qt::Key(Qt::Key_0 + ++row % digits)));
        panels->addAction(toggle);
    }
}

void ViewMenu::addPalettes(PaletteSwitch *palettes)
{
    QMenu *menu = addMenu(tr("&Colours"));
    menu->setObjectName(u"paletteMenu"_s);
    auto *group = new QActionGroup(menu);
    addChoice(group, menu, "paletteSystem", tr("as the &desktop"), palettes, PaletteChoice::System);
    addChoice(group, menu, "paletteLight", tr("&light"), palettes, PaletteChoice::Light);
    addChoice(group, menu, "paletteDark", tr("d&ark"), palettes, PaletteChoice::Dark);
}

} // namespace pixelplumb
