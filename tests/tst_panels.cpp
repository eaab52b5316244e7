// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"
#include "core/runs/formulaexplanation.h"
#include "tests/support/defaultscene.h"
#include "tests/support/spacescenes.h"
#include "tests/support/tablecolumns.h"
#include "widgets/inspect/columntable.h"
#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/playhead.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QScrollBar>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

using namespace pixelplumb;

class TestPanels : public QObject {
    Q_OBJECT

private slots:
    void choosingARowGoesToItsColumn();
    void steppingMovesTheCurrentRow();
    void gettingTheFocusDoesNotMoveThePosition();
    void copiedRowsAgreeWithTheExportedTrace_data();
    void copiedRowsAgreeWithTheExportedTrace();
    void switchesShowAndHideGroupsOfColumns();
    void widthsStayWhileStepping();
    void formulasNameTheNumbersOfTheStep();
    void theWayFromSpaceStandsWhereASolidsTriangleBegins();
    void theChangeOfHalfIsAnEvent();
    void anEmptySceneSaysWhatToDo();
    void formulasKeepTheirPlaceWhileStepping();
};

void TestPanels::choosingARowGoesToItsColumn()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    ColumnTable table(&playhead);

    table.selectRow(rowOf(27));

    QCOMPARE(playhead.columnXInHand(), std::int64_t(27));
    QVERIFY(!playhead.pixelInHand());
}

void TestPanels::steppingMovesTheCurrentRow()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    ColumnTable table(&playhead);
    playhead.seekToSpan(std::size_t(rowOf(30)));

    playhead.step(StepUnit::Sample, StepDirection::Forward);
    QCOMPARE(table.currentIndex().row(), rowOf(30));
    QVERIFY(playhead.pixelInHand()); // the table did not pull the position back

    playhead.step(StepUnit::Span, StepDirection::Forward);
    QCOMPARE(table.currentIndex().row(), rowOf(31));
    QCOMPARE(table.selectionModel()->selectedRows().size(), 1);

    playhead.seek(0);
    QVERIFY(!table.selectionModel()->hasSelection());
}

void TestPanels::gettingTheFocusDoesNotMoveThePosition()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    ColumnTable table(&playhead);
    table.show();

    table.setFocus();
    QApplication::setActiveWindow(&table);

    QTRY_VERIFY(table.hasFocus());
    QCOMPARE(playhead.position(), std::size_t(0));
}

void TestPanels::copiedRowsAgreeWithTheExportedTrace_data()
{
    QTest::addColumn<Arithmetic>("arithmetic");
    for (const Arithmetic arithmetic : allArithmetics)
        QTest::newRow(nameOf(arithmetic).data()) << arithmetic;
}

void TestPanels::copiedRowsAgreeWithTheExportedTrace()
{
    QFETCH(const Arithmetic, arithmetic);
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(arithmetic)));
    ColumnTable table(&playhead);
    for (QAction *action : table.columnActions())
        action->setChecked(true);
    table.selectRow(rowOf(33));

    QTest::keySequence(&table, QKeySequence::Copy);

    const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    const QStringList names = lines[0].split(u'\t');
    const QStringList copied = lines[1].split(u'\t');
    QCOMPARE(copied.size(), names.size());
    const TraceTable<SpanRow> exported = spanTable(playhead.traced()->method->numbers.span);
    const std::vector<Field> &fields = exported.fields();
    const std::vector<Cell> cells
        = exported.cells(spanRow(*playhead.traced(), std::size_t(rowOf(33))));
    int compared = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const qsizetype place = names.indexOf(fields[i].name);
        if (place < 0)
            continue;
        QCOMPARE(copied[place], fileText(fields[i], cells[i]));
        ++compared;
    }
    QCOMPARE(compared, names.size());
}

void TestPanels::switchesShowAndHideGroupsOfColumns()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Float32)));
    ColumnTablePanel panel(&playhead);
    const ColumnTable &table = *panel.table();
    const auto &model = *qobject_cast<ColumnTableModel *>(table.model());
    const auto isShown
        = [&](const char *name) { return !table.isColumnHidden(columnNamed(model, name)); };
    const auto press
        = [&](const char *name) { panel.findChild<QToolButton *>(QLatin1String(name))->click(); };

    QVERIFY(isShown("R_B") && !isShown("R_B_exact") && !isShown("primitive"));
    press("showExactButton");
    QVERIFY(isShown("R_B_exact") && !isShown("R_B_error"));
    press("showEdgeColoursButton");
    QVERIFY(!isShown("R_B") && !isShown("R_B_exact") && isShown("y_B"));

    // What was chosen outlasts a new run.
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Float64)));
    QVERIFY(!isShown("R_B") && isShown("y_B_exact"));
}

void TestPanels::widthsStayWhileStepping()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    ColumnTable table(&playhead);
    table.resize(1200, 220);
    table.show();
    const auto widths = [&table] {
        QList<int> all;
        for (int column = 0; column < table.model()->columnCount(); ++column)
            all.append(table.columnWidth(column));
        return all;
    };
    const QList<int> before = widths();

    for (int step = 0; step < 55; ++step)
        playhead.step(StepUnit::Span, StepDirection::Forward);

    QCOMPARE(widths(), before);
}

void TestPanels::formulasNameTheNumbersOfTheStep()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Float32)));
    FormulaPanel panel(&playhead);

    playhead.seekToSpan(std::size_t(rowOf(33)));

    const Explanation explanation = explainStep(*playhead.traced(), playhead.position() - 1);
    const QString text = panel.findChild<QTextBrowser *>()->toPlainText();
    QVERIFY(!explanation.lines.empty());
    for (const FormulaLine &line : explanation.lines) {
        QVERIFY2(text.contains(displayText(line.used)), qPrintable(line.symbols));
        if (!line.exact.isNone())
            QVERIFY2(text.contains(displayError(line.used, line.exact)), qPrintable(line.symbols));
    }
    QVERIFY(panel.accessibleDescription().contains(explanation.sentence));
}

void TestPanels::theWayFromSpaceStandsWhereASolidsTriangleBegins()
{
    Playhead playhead;
    playhead.setTraced(traceScene(sceneOf({triangle3({0, 0, 2}, {1, 0, -2}, {0, 1, 4.5})})));
    FormulaPanel panel(&playhead);
    const auto *browser = panel.findChild<QTextBrowser *>();

    playhead.seek(playhead.traced()->trace->indexOfSetUp(0) + 1);
    const Explanation explanation = explainStep(*playhead.traced(), playhead.position() - 1);
    const QString text = browser->toPlainText();
    QCOMPARE(explanation.stages.front().stage, QStringLiteral("Vertex"));
    QCOMPARE(explanation.stages.back().stage, QStringLiteral("Lattice"));
    for (const StageFormulas &stage : explanation.stages) {
        QVERIFY2(text.contains(stage.stage), qPrintable(stage.stage));
        for (const FormulaLine &line : stage.lines) {
            QVERIFY2(text.contains(displayText(line.used)), qPrintable(line.symbols));
            if (!line.exact.isNone())
                QVERIFY2(text.contains(displayError(line.used, line.exact)),
                         qPrintable(line.symbols));
        }
    }
    QVERIFY(panel.accessibleDescription().contains(QStringLiteral("Clip coordinates")));

    playhead.seekToSpan(0);
    QVERIFY(!browser->toPlainText().contains(QStringLiteral("Clip coordinates")));
}

void TestPanels::theChangeOfHalfIsAnEvent()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    FormulaPanel panel(&playhead);
    auto *heading = panel.findChild<QLabel *>(QStringLiteral("formulaHeading"));

    playhead.seekToSpan(std::size_t(rowOf(26)));
    QVERIFY(!heading->text().contains(QStringLiteral("⚑")));

    playhead.seekToSpan(std::size_t(rowOf(27)));
    QVERIFY(heading->text().contains(QStringLiteral("⚑")));
    QVERIFY(heading->text().contains(QStringLiteral("L₁₂")));
}

void TestPanels::anEmptySceneSaysWhatToDo()
{
    Playhead playhead;
    FormulaPanel panel(&playhead);
    const auto *sentence = panel.findChild<QLabel *>(QStringLiteral("formulaSentence"));

    QVERIFY(sentence->text().contains(QStringLiteral("Click three points on the canvas")));

    playhead.setTraced(traceScene(Scene()));
    QVERIFY(sentence->text().contains(QStringLiteral("Click three points on the canvas")));
}

void TestPanels::formulasKeepTheirPlaceWhileStepping()
{
    Playhead playhead;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    FormulaPanel panel(&playhead);
    panel.resize(440, 240);
    panel.show();
    playhead.seekToSpan(std::size_t(rowOf(30)));
    auto *formulas = panel.findChild<QTextBrowser *>();
    formulas->verticalScrollBar()->setValue(60);
    const QRect place = formulas->geometry();

    playhead.step(StepUnit::Span, StepDirection::Forward);

    QCOMPARE(formulas->geometry(), place);
    QCOMPARE(formulas->verticalScrollBar()->value(), 60);
}

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
