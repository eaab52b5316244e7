// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/whatsthis.h"

#include "widgets/look/menuaction.h"
#include "widgets/window/panels.h"
#include "widgets/window/workspaces.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

struct PartExplanation {
    const char *name; ///< of the part
    const char *text;
};

constexpr const char *explanationContext = "pixelplumb::WhatsThis";

constexpr PartExplanation explanations[] = {
    {"canvas",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The frame as it is at the current step, with its triangles and the plumb line through "
         "the current column or row. With the tool Draw a click places a vertex and a drag moves "
         "one, with Inspect a click picks the pixel; a right click always picks. Arrows move the "
         "picked pixel, the wheel zooms, Shift shows the truth as long as it is held.")},
    {"scrubber",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "Timeline of the steps, lined up with the picture, with marks at vertices, ties and "
         "clamps and at the first wrong pixel. A drag goes to another step. Arrows go by the unit "
         "of playing, with Ctrl from mark to "
         "mark, PageUp and PageDown by columns or rows, Home and End to the ends.")},
    {"methodBox",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "The method that draws the scene. The buttons, the table and the formulas "
                       "follow it; the menu Method shows the keys that choose one on the canvas.")},
    {"statusPixel",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "The pixel under the pointer, else the picked one, and its colour.")},
    {"statusColumn",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis", "The column, row or step of the current method.")},
    {"statusStep",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "How many of the run's steps are done. A step writes a pixel, begins a "
                       "column or row, or sets a primitive up; Step ▸ Go to… goes to any.")},
    {"statusSettings",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "The arithmetic, the fill rule and the frame's convention that the scene is "
                       "drawn by.")},

    {"formulaDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The current step as formulas with its numbers put in: what the drawing used, beside the "
         "exact value. The entries of the menu Step go on and back by a column or row, or by a "
         "pixel.")},
    {"pixelGridDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The pixels around the picked one, large enough to read: their bytes, their sample "
         "points, the true edges, and where the current column or row meets them. Arrows move the "
         "picked "
         "pixel, + and − make the cells larger and smaller, Enter goes to the step that wrote "
         "it.")},
    {"pixelHistoryDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "How the picked pixel got its colour: each primitive that tried, with its numbers, or the "
         "edge that refuses the pixel and by how much. Enter on a line goes to that step.")},
    {"columnsDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The numbers of every column (with other methods, every row or step), as the drawing used "
         "them; exact ones can be shown next to them. A click on a row goes to it.")},
    {"compareDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Two to four methods, or the truth, draw the scene side by side, and a map "
                       "shows where they agree; the text below says why the picked pixel differs. "
                       "Arrows move the picked pixel, + and − zoom all of them.")},
    {"precisionDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "How far the bounds that each arithmetic computes are from the exact edges "
                       "of the current triangle, column by column.")},
    {"hardCasesDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The gallery of hard cases by family, each drawn by the current method beside the truth, "
         "and whether the method is right. Its buttons open a case in the window.")},
    {"performanceDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "What drawing the scene takes by the plain and by the fast kernels, which of them took "
         "which triangles and why, and what columns and rows ask of the cache.")},
    {"operationsDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "How many divisions, roundings, additions and other operations a set-up, a "
                       "span and a sample take in the current method and arithmetic.")},
    {"accuracyLabDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "What accuracy costs in time: Run judges and times every method in every arithmetic, and "
         "the chart shows cost against error. Arrows go from dot to dot, Enter opens the dot's "
         "first wrong pixel.")},
    {"projectionDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "How the current triangle came from three dimensions to the frame: the camera from the "
         "side, and every stage with its numbers. Arrows turn the view, + and − bring it nearer "
         "and farther, Home brings the first view back.")},
    {"effectsDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Which effects the scene calls for, why, and what each costs. Only what is "
                       "called for runs; a switch forces an effect on or off in the picture.")},
    {"methodDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The current method: what it does, where it comes from, and its pseudocode, with the "
         "lines that the current step does marked.")},
    {"predictDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Asks for what comes next (y_B, the rows, the increments or the next pixel) "
                       "before it is shown, and says whether the answer is right, and why. Enter "
                       "checks what is typed, a number or the pixel's x, y, and goes on. While "
                       "this panel is open, the others hide the truth and what lies ahead.")},
    {"motionDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "Lets the scene move by a fraction of a pixel a frame, and counts the pixels that flicker "
         "beside those of the truth. The frame of its slider is what the canvas shows and what is "
         "stepped through.")},
    {"primitivesDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The scene's primitives in drawing order. The box before a name shows or hides the "
         "primitive, coordinates and colours are typed in place, and the buttons below, which a "
         "right click "
         "shows as a menu, move, recolour and delete it.")},
    {"submissionDock",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "How a student's picture, dropped on the window or pasted, differs from the "
                       "expected one, by cause, with both pictures; Name the bug "
                       "looks for known defects that draw it.")},
    {"gradingDock",
     QT_TRANSLATE_NOOP(
         "pixelplumb::WhatsThis",
         "The submissions of a graded folder, by cause, with what each student is told. J and K go "
         "to the next and the previous one, A accepts its grade, C comments on it.")},

    {"fileMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Opens, saves and exports scenes, and shows the examples.")},
    {"editMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Changes the scene, and takes back what was changed; chooses what a click "
                       "on the canvas does.")},
    {"viewMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "What is drawn over the frame, how large, in which colours, and which "
                       "workspace and panels are shown.")},
    {"layersMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Lays the figures of the course texts over the scene, at the current "
                       "step.")},
    {"stepMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "Goes through the run of the scene, forward and back.")},
    {"methodMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "The method that draws the scene, and its printed variants with their "
                       "faults.")},
    {"helpMenu",
     QT_TRANSLATE_NOOP("pixelplumb::WhatsThis",
                       "The manual, all keys, and what the parts of the window are.")},
};

/// A part's explanation; empty where the table has none.
QString explanationOf(const QString &name)
{
    const auto *row = std::ranges::find_if(explanations, [&name](const PartExplanation &each) {
        return name == QLatin1String(each.name);
    });
    return row == std::end(explanations)
        ? QString()
        : QCoreApplication::translate(explanationContext, row->text);
}

/// An action's explanation; for a dock's toggle, the dock's.
QString explanationOf(const QAction &action)
{
    QString name = action.objectName();
    if (name.endsWith(QLatin1String("DockToggle")))
        name.chop(int(qstrlen("Toggle")));
    const QString text = explanationOf(name);
    const bool hasTip = action.toolTip() != QAction(action.text()).toolTip(); // else its text's
    return text.isEmpty() && hasTip ? action.toolTip() : text;
}

} // namespace

void explainParts(QWidget *window)
{
    for (QAction *action : window->findChildren<QAction *>())
        action->setWhatsThis(explanationOf(*action));
    for (QWidget *part : window->findChildren<QWidget *>()) {
        const QString text = explanationOf(part->objectName());
        part->setWhatsThis(text.isEmpty() ? part->toolTip() : text);
    }
}

QString panelsHtml(const QWidget *window)
{
    QString html;
    for (const Panel &panel : panels()) {
        const auto *dock = window->findChild<QDockWidget *>(QLatin1String(panel.dock));
        const auto *toggle = window->findChild<QAction *>(QLatin1String(panel.dock) + u"Toggle"_s);
        html += u"<h3>%1 &nbsp;<small>%2 · %3</small></h3><p>%4</p>"_s.arg(
            dock->windowTitle().toHtmlEscaped(), withoutMnemonic(titleOf(panel.workspace)),
            toggle->shortcut().toString(QKeySequence::NativeText),
            explanationOf(QLatin1String(panel.dock)).toHtmlEscaped());
    }
    return html;
}

void enterWhatsThis(QWidget *window)
{
    explainParts(window);
    QWhatsThis::enterWhatsThisMode();
}

} // namespace pixelplumb
