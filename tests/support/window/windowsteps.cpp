// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/windowsteps.h"

#include "core/runs/explain/formulaexplanation.h"
#include "core/scan/choicenames.h"
#include "tests/support/spread.h"
#include "tests/support/window/openwindow.h"
#include "widgets/inspect/columntable.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QLabel>
#include <QTest>

namespace pixelplumb {

namespace {

constexpr std::size_t mostPositions = 8;
constexpr std::size_t mostRows = 8;

/// The current run, and how much of it is checked.
QString nameOfRun(const TracedScene &traced)
{
    return u"%1 %2, %3 of %4 positions and %5 of %6 rows"_s
        .arg(traced.method->id, nameText(nameOf(traced.scene.settings.arithmetic)))
        .arg(std::min(mostPositions, traced.trace->stepCount() + 1))
        .arg(traced.trace->stepCount() + 1)
        .arg(std::min(mostRows, traced.trace->spanCount()))
        .arg(traced.trace->spanCount());
}

/// The total length of all texts in some rows; computing it creates every text.
qsizetype lengthOfTexts(const QAbstractItemModel &model)
{
    qsizetype length = 0;
    for (const std::size_t row : spreadOver(std::size_t(model.rowCount()), mostRows)) {
        for (int column = 0; column < model.columnCount(); ++column) {
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                length += model.index(int(row), column).data(role).toString().size();
        }
    }
    return length;
}

} // namespace

bool waitForRun(const MainWindow &window)
{
    const Playhead &playhead = *window.parts().playhead;
    const SceneDocument &document = *window.parts().document;
    return QTest::qWaitFor(
        [&] { return playhead.traced() && playhead.traced()->scene == document.scene(); }, 120'000);
}

QString faultInSteps(const MainWindow &window)
{
    Playhead &playhead = *window.parts().playhead;
    const TracedScene &traced = *playhead.traced();
    const QString name = nameOfRun(traced);
    for (const std::size_t position : spreadOver(traced.trace->stepCount() + 1, mostPositions)) {
        playhead.seek(position);
        if (playhead.position() != position)
            return u"%1: position %2 cannot be reached"_s.arg(name).arg(position);
        if (position > 0 && explainStep(traced, position - 1).sentence.isEmpty())
            return u"%1: nothing is said of step %2"_s.arg(name).arg(position);
        if (named<QLabel>(window, "formulaHeading")->text().isEmpty())
            return u"%1: no heading at position %2"_s.arg(name).arg(position);
    }
    const QAbstractItemModel &table = *named<ColumnTable>(window, "columnTable")->model();
    if (traced.trace->spanCount() > 0 && lengthOfTexts(table) == 0)
        return name + u": the column table is empty"_s;
    return {};
}

} // namespace pixelplumb
