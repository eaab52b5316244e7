// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/stepmenu.h"

#include "widgets/dialogs/gotodialog.h"
#include "widgets/look/menuaction.h"
#include "widgets/stepping/scrubber.h"
#include "widgets/stepping/stepactions.h"

namespace pixelplumb {

StepMenu::StepMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Step"), window)
{
    setObjectName(QStringLiteral("stepMenu"));
    const StepActions &steps = *parts.steps;
    for (const StepUnit unit : {StepUnit::Span, StepUnit::Sample, StepUnit::SetUp}) {
        addAction(steps.step(unit, StepDirection::Forward));
        addAction(steps.step(unit, StepDirection::Backward));
    }
    addSeparator();
    addAction(steps.play());
    QMenu *units = addMenu(tr("Play &by"));
    units->setObjectName(QStringLiteral("unitMenu"));
    units->addActions(steps.units());
    addSeparator();
    addAction(steps.toEnd());
    addAction(steps.toStart());
    addAction(steps.runToPixel(StepDirection::Forward));
    addAction(steps.runToPixel(StepDirection::Backward));
    Scrubber *scrubber = parts.scrubber;
    addMenuAction(this, "nextMark", tr("Next &mark"), Qt::Key_F8,
                  [scrubber] { scrubber->goToMark(StepDirection::Forward); });
    addMenuAction(this, "previousMark", tr("Previous m&ark"), Qt::SHIFT | Qt::Key_F8,
                  [scrubber] { scrubber->goToMark(StepDirection::Backward); });
    Playhead *playhead = parts.playhead;
    addMenuAction(this, "goTo", tr("&Go to…"), Qt::CTRL | Qt::Key_G, [playhead, window] {
        GoToDialog dialog(playhead, window);
        dialog.exec();
    });
    addSeparator();
    addAction(steps.toggleColumnBreakpoint());
    addAction(steps.togglePixelBreakpoint());
    addAction(steps.clearBreakpoints());
}

} // namespace pixelplumb
