// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/studylinks.h"

#include "widgets/canvas/canvas.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/messagebar.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/accuracy/precisionpanel.h"
#include "widgets/studies/cases/hardcasespanel.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/gradingpanel.h"
#include "widgets/studies/grade/openings.h"
#include "widgets/studies/grade/submissionpanel.h"
#include "widgets/window/examplesdialog.h"
#include "widgets/window/mainwindow.h"
#include "widgets/window/windowdocks.h"
#include "widgets/window/workspaces.h"

#include <QMessageBox>
#include <QPushButton>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace pixelplumb {

namespace {

constexpr int readableZoom = 8; ///< device pixels per frame pixel at which marks are legible

/// Zooms so that the picked pixel, which keeps its place in the view, can be seen singly.
void showPickedPixel(Canvas &canvas)
{
    canvas.fitToView();
    if (canvas.zoom() < readableZoom)
        canvas.setZoom(readableZoom);
}

/// Connects a set of defects to the document: it is opened as the scene, and left again.
DefectStepper *connectDiagnosis(const WindowParts &parts, WindowDocks &docks, MainWindow *window)
{
    auto *stepper = new DefectStepper(parts.document, parts.student, window);
    QObject::connect(stepper, &DefectStepper::opened, window,
                     [window, options = parts.options](std::size_t position) {
                         options->setStudentShown(false);
                         window->setOpeningPlace(position);
                     });
    docks.whenBuilt<SubmissionPanel>([&docks, stepper](SubmissionPanel *panel) {
        DiagnosisView *diagnosis = panel->diagnosis();
        QObject::connect(diagnosis, &DiagnosisView::openRequested, stepper,
                         [&docks, stepper](const DefectOpening &opening) {
                             stepper->open(opening);
                             docks.raise<FormulaPanel>(); // where a run is stepped
                         });
        QObject::connect(diagnosis, &DiagnosisView::leaveRequested, stepper, &DefectStepper::leave);
        QObject::connect(stepper, &DefectStepper::leavingChanged, diagnosis,
                         &DiagnosisView::setLeaving);
        QObject::connect(
            diagnosis, &DiagnosisView::compareRequested, stepper,
            [&docks, stepper](const DefectOpening &opening) {
                stepper->open(opening);
                const Method *method = methodNamed(QString::fromStdString(opening.right->method));
                docks.raise<ComparePanel>()->setContenders(
                    {{method, opening.defective.settings}, {method, opening.right->settings}});
            });
    });
    return stepper;
}

/// What a box offers: the button's words, and what it does.
struct Offer {
    QString answer;
    std::function<void()> accepted;
};

/// Says that a file is not what was asked for, and offers what it is for; the first offer is the
/// default.
void offer(const char *name, const QString &text, const QString &question,
           const std::vector<Offer> &offers, QWidget *window)
{
    auto *box = named(new QMessageBox(QMessageBox::Question, {}, text, QMessageBox::Cancel, window),
                      name);
    box->setTextFormat(Qt::PlainText); // a name may look like HTML
    box->setInformativeText(question);
    box->setAttribute(Qt::WA_DeleteOnClose);
    for (const Offer &each : offers) {
        QPushButton *button = box->addButton(each.answer, QMessageBox::AcceptRole);
        if (&each == &offers.front())
            box->setDefaultButton(button);
        QObject::connect(box, &QMessageBox::finished, window, [box, button, each] {
            if (box->clickedButton() == button)
                each.accepted();
        });
    }
    box->open();
}

/// Connects what is opened as a scene and is an assignment, and the other way round.
void connectMixedUpFiles(const WindowParts &parts, WindowDocks &docks, MainWindow *window)
{
    // Queued: the window may not be shown yet, or another dialog is still closing.
    QObject::connect(
        parts.files, &SceneFiles::assignmentMet, window,
        [&docks, window](const QString &path) {
            offer("assignmentMet",
                  MainWindow::tr("“%1” is an assignment, not a scene.").arg(shownName(path)),
                  MainWindow::tr("A folder of submissions is graded by it."),
                  {{MainWindow::tr("&Grade a folder…"),
                    [&docks, path] { docks.raise<GradingPanel>()->gradeBy(path); }}},
                  window);
        },
        Qt::QueuedConnection);
    docks.whenBuilt<GradingPanel>([parts, window](GradingPanel *grading) {
        QObject::connect(
            grading, &GradingPanel::sceneMet, window,
            [parts, grading, window](const QString &path) {
                offer("sceneMet",
                      MainWindow::tr("“%1” is a scene, not an assignment.").arg(shownName(path)),
                      MainWindow::tr("An assignment names the scenes that submissions draw, and "
                                     "what each is worth. Without one, this scene can be the only "
                                     "task, for 5 points."),
                      {{MainWindow::tr("&Grade by this scene"),
                        [grading, path] { grading->gradeByScene(path); }},
                       {MainWindow::tr("&Open the scene"),
                        [parts, path] { parts.files->openFile(path); }}},
                      window);
            },
            Qt::QueuedConnection);
    });
}

/// Connects grading: a graded picture opens in Submission, at its first difference.
void connectGrading(const WindowParts &parts, WindowDocks &docks, DefectStepper *stepper,
                    MainWindow *window)
{
    auto *opening
        = new SubmissionOpening(parts.document, parts.files, parts.student, parts.playhead, window);
    const auto raise = [&docks] { docks.raise<SubmissionPanel>(); };
    docks.whenBuilt<GradingPanel>([=](GradingPanel *grading) {
        QObject::connect(grading, &GradingPanel::openRequested, stepper, &DefectStepper::leave);
        QObject::connect(grading, &GradingPanel::openRequested, opening, &SubmissionOpening::open);
        QObject::connect(grading, &GradingPanel::closeRequested, opening,
                         &SubmissionOpening::close);
        QObject::connect(opening, &SubmissionOpening::lost, grading, &GradingPanel::putDown);
        QObject::connect(grading, &GradingPanel::openRequested, window, raise);
        QObject::connect(grading->book(), &Gradebook::complaint, parts.messageBar,
                         &MessageBar::complain);
        QObject::connect(grading->book(), &Gradebook::notice, parts.playhead, &Playhead::message);
    });
    docks.whenBuilt<SubmissionPanel>([opening](SubmissionPanel *panel) {
        QObject::connect(opening, &SubmissionOpening::pixelReached, panel,
                         &SubmissionPanel::lookAt);
    });
    QObject::connect(opening, &SubmissionOpening::pixelReached, window, raise);
    QObject::connect(opening, &SubmissionOpening::arrived, parts.options,
                     [options = parts.options] { options->setStudentShown(true); });
}

/// Connects a student's picture: its marks and its verdict are shown at once.
void connectSubmission(const WindowParts &parts, WindowDocks &docks, MainWindow *window)
{
    connectGrading(parts, docks, connectDiagnosis(parts, docks, window), window);
    QObject::connect(parts.student, &StudentPicture::taken, window, [&docks, parts] {
        parts.options->setDifferencesShown(true);
        parts.options->setTruthShown(false);
        parts.options->setStudentShown(true);
        docks.raise<SubmissionPanel>();
    });
    // Who steps wants to see the run; another run is no step.
    QObject::connect(parts.playhead, &Playhead::positionChanged, parts.options,
                     [parts, stepped = std::weak_ptr<const TracedScene>()]() mutable {
                         const auto traced = parts.playhead->sharedTraced();
                         const auto before = std::exchange(stepped, traced).lock();
                         if (traced && traced == before)
                             parts.options->setStudentShown(false);
                     });
    docks.whenBuilt<SubmissionPanel>([pictures = parts.pictures](SubmissionPanel *panel) {
        QObject::connect(panel, &SubmissionPanel::openRequested, pictures,
                         &StudentPictureFiles::open);
    });
    // A closed panel means that the picture is no longer needed; else it waits for its scene.
    QObject::connect(parts.files, &SceneFiles::replacing, parts.student,
                     [&docks, student = parts.student] {
                         if (docks.isClosed(*docks.dockOf<SubmissionPanel>()))
                             student->remove();
                     });
    QObject::connect(parts.student, &StudentPicture::complaint, parts.messageBar,
                     &MessageBar::complain);
    QObject::connect(parts.playhead, &Playhead::pixelChosen, window,
                     [&docks, window, student = parts.student](const QPoint &pixel) {
                         const auto &judgement = student->judgement();
                         QDockWidget *submission = docks.dockOf<SubmissionPanel>();
                         QDockWidget *history = docks.dockOf<PixelHistoryPanel>();
                         // Never covers the clicked widget, and never takes a grader to another
                         // workspace.
                         const bool covers = submission->underMouse()
                             && window->tabifiedDockWidgets(history).contains(submission);
                         if (docks.workspaces()->current() == Workspace::Step && judgement
                             && judgement->verdictAt(pixel) != Difference::None && !covers)
                             docks.raise(history);
                     });
}

/// Connects the lab: it knows the scene's file, and its wrong pixels open beside the truth.
void connectLab(const WindowParts &parts, WindowDocks &docks, DifferenceOpening *opening)
{
    docks.whenBuilt<AccuracyLab>([parts, &docks, opening](AccuracyLab *lab) {
        const auto followFile = [lab, files = parts.files] { lab->setScenePath(files->path()); };
        followFile();
        lab->setSceneModified(parts.document->isModified());
        QObject::connect(parts.files, &SceneFiles::pathChanged, lab, followFile);
        QObject::connect(parts.document, &SceneDocument::modifiedChanged, lab,
                         &AccuracyLab::setSceneModified);
        QObject::connect(lab, &AccuracyLab::complaint, parts.messageBar, &MessageBar::complain);
        QObject::connect(lab, &AccuracyLab::notice, parts.playhead, &Playhead::message);
        QObject::connect(
            lab, &AccuracyLab::missRequested, opening,
            [&docks, opening, canvas = parts.canvas](const LabMiss &miss) {
                if (!opening->openAt(miss.scene, QPoint(int(miss.x), int(miss.y))))
                    return;
                const Method *method = methodNamed(QString::fromStdString(miss.scene.method));
                docks.raise<ComparePanel>()->setContenders(
                    {{method, miss.scene.settings}, {nullptr, miss.scene.settings}});
                // The canvas has another size in this workspace.
                QMetaObject::invokeMethod(
                    canvas, [canvas] { showPickedPixel(*canvas); }, Qt::QueuedConnection);
            });
    });
}

} // namespace

void connectStudies(const WindowParts &parts, WindowDocks &docks, MainWindow *window)
{
    connectSubmission(parts, docks, window);
    connectMixedUpFiles(parts, docks, window);
    auto *opening = new DifferenceOpening(parts.files, parts.playhead, window);
    docks.whenBuilt<HardCasesPanel>([&docks, opening](HardCasesPanel *cases) {
        QObject::connect(cases, &HardCasesPanel::openRequested, opening, &DifferenceOpening::open);
        QObject::connect(cases, &HardCasesPanel::compareRequested, opening,
                         [&docks](const std::vector<Contender> &contenders) {
                             docks.raise<ComparePanel>()->setContenders(contenders);
                         });
        QObject::connect(cases, &HardCasesPanel::precisionRequested, opening,
                         [&docks] { docks.raise<PrecisionPanel>(); });
    });
    docks.whenBuilt<ComparePanel>([opening](ComparePanel *compare) {
        QObject::connect(opening, &DifferenceOpening::pixelReached, compare, &ComparePanel::lookAt);
    });
    QObject::connect(opening, &DifferenceOpening::pixelReached, parts.canvas,
                     [canvas = parts.canvas] { showPickedPixel(*canvas); });
    connectLab(parts, docks, opening);
}

void showExamples(const WindowParts &parts, WindowDocks &docks, QWidget *window)
{
    auto *panel = docks.panel<HardCasesPanel>();
    panel->load();
    auto *dialog = new ExamplesDialog(examples(), panel->cases(), window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &ExamplesDialog::sceneChosen, parts.files, &SceneFiles::openFile,
                     Qt::QueuedConnection); // it may ask, after the dialog has closed
    QObject::connect(dialog, &ExamplesDialog::caseChosen, panel,
                     [&docks](const QString &id) { docks.raise<HardCasesPanel>()->choose(id); });
    dialog->open();
}

} // namespace pixelplumb
