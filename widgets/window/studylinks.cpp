// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/studylinks.h"

#include "widgets/canvas/canvas.h"
#include "widgets/files/scenefiles.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/comparepanel.h"
#include "widgets/studies/differenceopening.h"
#include "widgets/studies/hardcasespanel.h"
#include "widgets/studies/precisionpanel.h"
#include "widgets/window/examplesdialog.h"
#include "widgets/window/windowdocks.h"

namespace pixelplumb {

namespace {

constexpr int readableZoom = 8; ///< device pixels a frame pixel: its mark can be told

/// So that the picked pixel, which keeps its place in the view, can be seen by itself.
void showPickedPixel(Canvas &canvas)
{
    canvas.fitToView();
    if (canvas.zoom() < readableZoom)
        canvas.setZoom(readableZoom);
}

/// In front, with these in its panes.
void showComparison(WindowDocks &docks, const std::vector<Contender> &contenders)
{
    auto *compare = docks.panel<ComparePanel>();
    docks.raise(compare);
    compare->setContenders(contenders);
}

} // namespace

void connectStudies(const WindowParts &parts, WindowDocks &docks, QObject *window)
{
    auto *opening = new DifferenceOpening(parts.files, parts.playhead, window);
    auto *cases = docks.panel<HardCasesPanel>();
    QObject::connect(cases, &HardCasesPanel::openRequested, opening, &DifferenceOpening::open);
    QObject::connect(
        cases, &HardCasesPanel::compareRequested, window,
        [&docks](const std::vector<Contender> &contenders) { showComparison(docks, contenders); });
    QObject::connect(cases, &HardCasesPanel::precisionRequested, window,
                     [&docks] { docks.raise(docks.panel<PrecisionPanel>()); });

    auto *lab = docks.panel<AccuracyLab>();
    auto *compare = docks.panel<ComparePanel>();
    QObject::connect(opening, &DifferenceOpening::pixelReached, compare, &ComparePanel::lookAt);
    QObject::connect(opening, &DifferenceOpening::pixelReached, parts.canvas,
                     [canvas = parts.canvas] { showPickedPixel(*canvas); });
    QObject::connect(
        lab, &AccuracyLab::missRequested, window, [&docks, opening](const LabMiss &miss) {
            if (!opening->openAt(miss.scene, QPoint(int(miss.x), int(miss.y))))
                return;
            const Method *method = methodNamed(QString::fromStdString(miss.scene.method));
            showComparison(docks, {{method, miss.scene.settings}, {nullptr, miss.scene.settings}});
        });
    QObject::connect(parts.document, &SceneDocument::modifiedChanged, lab,
                     &AccuracyLab::setSceneModified);
    QObject::connect(lab, &AccuracyLab::complaint, parts.messageBar, &MessageBar::complain);
    QObject::connect(lab, &AccuracyLab::notice, parts.playhead, &Playhead::message);
}

void showExamples(const WindowParts &parts, WindowDocks &docks, QWidget *window)
{
    auto *panel = docks.panel<HardCasesPanel>();
    panel->load();
    auto *dialog = new ExamplesDialog(examples(), panel->cases(), window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &ExamplesDialog::sceneChosen, parts.files, &SceneFiles::openFile,
                     Qt::QueuedConnection); // which may ask, when the dialog is gone
    QObject::connect(dialog, &ExamplesDialog::caseChosen, panel,
                     [&docks, panel](const QString &id) {
                         docks.raise(panel);
                         panel->choose(id);
                     });
    dialog->open();
}

} // namespace pixelplumb
