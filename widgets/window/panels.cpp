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
#include "widgets/look/parts.h"
#include "widgets/space/projectionpanel.h"
#include "widgets/studies/accuracy/motionpanel.h"
#include "widgets/studies/accuracy/precisionpanel.h"
#include "widgets/studies/cases/hardcasespanel.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/cost/effectspanel.h"
#include "widgets/studies/cost/operationpanel.h"
#include "widgets/studies/cost/performancepanel.h"
#include "widgets/studies/grade/gradingpanel.h"
#include "widgets/studies/grade/submissionpanel.h"

namespace pixelplumb {

namespace {

/// A panel that is given these parts of the window.
template <class Widget, auto... parts>
constexpr Panel::Kind kind
    = {&Widget::staticMetaObject, []([[maybe_unused]] const WindowParts &all) -> QWidget * {
           return new Widget(all.*parts...);
       }};

template <class Widget>
constexpr Panel::Kind follower = kind<Widget, &WindowParts::playhead>;

constexpr auto theDocument = &WindowParts::document;
constexpr auto thePlayhead = &WindowParts::playhead;
constexpr Qt::DockWidgetArea leftArea = Qt::LeftDockWidgetArea;
constexpr Qt::DockWidgetArea rightArea = Qt::RightDockWidgetArea;
constexpr Qt::DockWidgetArea bottomArea = Qt::BottomDockWidgetArea;
constexpr auto shownAtFirst = Panel::AtFirst::Shown;
constexpr auto behindAtFirst = Panel::AtFirst::Behind;
constexpr auto hiddenAtFirst = Panel::AtFirst::Hidden;
constexpr auto tellsFinished = Panel::Tells::Finished;

constexpr Panel table[] = {
    {"formulaDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Formula"), follower<FormulaPanel>,
     Workspace::Step, rightArea, shownAtFirst},
    {"pixelGridDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Pixel grid"),
     kind<PixelGrid, thePlayhead, &WindowParts::options>, Workspace::Step, rightArea, shownAtFirst},
    {"pixelHistoryDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Pixel"),
     follower<PixelHistoryPanel>, Workspace::Step, rightArea, shownAtFirst},
    {"columnsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Columns"),
     follower<ColumnTablePanel>, Workspace::Step, bottomArea, shownAtFirst},
    {"compareDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Compare"), follower<ComparePanel>,
     Workspace::Compare, bottomArea, shownAtFirst, tellsFinished},
    {"precisionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Precision"),
     follower<PrecisionPanel>, Workspace::Compare, bottomArea, behindAtFirst, tellsFinished},
    {"hardCasesDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Hard cases"),
     follower<HardCasesPanel>, Workspace::Compare, leftArea, shownAtFirst, tellsFinished},
    {"performanceDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Performance"),
     follower<PerformancePanel>, Workspace::Measure, rightArea, behindAtFirst},
    {"operationsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Operations"),
     follower<OperationPanel>, Workspace::Measure, rightArea, behindAtFirst},
    {"accuracyLabDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Accuracy lab"),
     follower<AccuracyLab>, Workspace::Measure, rightArea, shownAtFirst},
    {"projectionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Projection"),
     kind<ProjectionPanel, theDocument, thePlayhead>, Workspace::Step, bottomArea, hiddenAtFirst},
    {"effectsDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Effects"),
     kind<EffectsPanel, theDocument, &WindowParts::effects>, Workspace::Measure, rightArea,
     behindAtFirst},
    {"methodDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "This method"),
     follower<MethodPanel>, Workspace::Step, leftArea, hiddenAtFirst},
    {"predictDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Predict"),
     kind<PredictPanel, theDocument, thePlayhead>, Workspace::Step, leftArea, hiddenAtFirst},
    {"motionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Motion"),
     kind<MotionPanel, theDocument>, Workspace::Compare, bottomArea, behindAtFirst, tellsFinished},
    {"primitivesDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Primitives"),
     kind<PrimitivesPanel, theDocument>, Workspace::Step, leftArea, hiddenAtFirst},
    {"submissionDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Submission"),
     kind<SubmissionPanel, &WindowParts::student, thePlayhead>, Workspace::Grade, leftArea,
     shownAtFirst, tellsFinished},
    {"gradingDock", QT_TRANSLATE_NOOP("pixelplumb::WindowDocks", "Grading"),
     kind<GradingPanel, theDocument>, Workspace::Grade, bottomArea, shownAtFirst},
};

} // namespace

std::span<const Panel> panels() { return table; }

} // namespace pixelplumb
