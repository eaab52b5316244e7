// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/panels.h"

#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/methodpanel.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/inspect/primitivespanel.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/look/namedwidget.h"
#include "widgets/space/projectionpanel.h"
#include "widgets/studies/comparepanel.h"
#include "widgets/studies/effectspanel.h"
#include "widgets/studies/gradingpanel.h"
#include "widgets/studies/hardcasespanel.h"
#include "widgets/studies/motionpanel.h"
#include "widgets/studies/operationpanel.h"
#include "widgets/studies/performancepanel.h"
#include "widgets/studies/precisionpanel.h"
#include "widgets/studies/submissionpanel.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

template <class Widget>
QWidget *follower(const WindowParts &parts)
{
    return new Widget(parts.playhead);
}

QWidget *pixelGrid(const WindowParts &parts)
{
    return new PixelGrid(parts.playhead, parts.options);
}

QWidget *projection(const WindowParts &parts)
{
    return new ProjectionPanel(parts.document, parts.playhead);
}

QWidget *effects(const WindowParts &parts)
{
    return new EffectsPanel(parts.document, parts.effects);
}

QWidget *motion(const WindowParts &parts) { return new MotionPanel(parts.document); }

QWidget *predict(const WindowParts &parts)
{
    return new PredictPanel(parts.document, parts.playhead);
}

QWidget *primitives(const WindowParts &parts) { return new PrimitivesPanel(parts.document); }

QWidget *grading(const WindowParts &) { return new GradingPanel; }

QWidget *submission(const WindowParts &parts)
{
    return new SubmissionPanel(parts.student, parts.playhead);
}

constexpr Qt::DockWidgetArea leftArea = Qt::LeftDockWidgetArea;
constexpr Qt::DockWidgetArea rightArea = Qt::RightDockWidgetArea;
constexpr Qt::DockWidgetArea bottomArea = Qt::BottomDockWidgetArea;
constexpr auto shownAtFirst = Panel::AtFirst::Shown;
constexpr auto hiddenAtFirst = Panel::AtFirst::Hidden;
constexpr auto finished = Panel::Tells::Finished;

constexpr Panel table[] = {
    {"formulaDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Formula"), follower<FormulaPanel>,
     rightArea, shownAtFirst},
    {"pixelGridDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Pixel grid"), pixelGrid,
     rightArea, shownAtFirst},
    {"pixelHistoryDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Pixel"),
     follower<PixelHistoryPanel>, rightArea, shownAtFirst},
    {"columnsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Columns"),
     follower<ColumnTablePanel>, bottomArea, shownAtFirst},
    {"compareDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Compare"), follower<ComparePanel>,
     bottomArea, hiddenAtFirst},
    {"precisionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Precision"),
     follower<PrecisionPanel>, bottomArea, hiddenAtFirst},
    {"hardCasesDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Hard cases"),
     follower<HardCasesPanel>, leftArea, hiddenAtFirst, finished},
    {"performanceDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Performance"),
     follower<PerformancePanel>, leftArea, hiddenAtFirst},
    {"operationsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Operations"),
     follower<OperationPanel>, bottomArea, hiddenAtFirst},
    {"accuracyLabDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Accuracy lab"),
     follower<AccuracyLab>, bottomArea, hiddenAtFirst},
    {"projectionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Projection"), projection,
     bottomArea, hiddenAtFirst},
    {"effectsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Effects"), effects, bottomArea,
     hiddenAtFirst},
    {"methodDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "This method"),
     follower<MethodPanel>, leftArea, hiddenAtFirst},
    {"predictDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Predict"), predict, leftArea,
     hiddenAtFirst},
    {"motionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Motion"), motion, bottomArea,
     hiddenAtFirst, finished},
    {"primitivesDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Primitives"), primitives,
     leftArea, hiddenAtFirst},
    {"submissionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Submission"), submission,
     leftArea, hiddenAtFirst, finished},
    {"gradingDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Grading"), grading, bottomArea,
     hiddenAtFirst},
};

} // namespace

std::span<const Panel> panels() { return table; }

} // namespace pixelplumb
