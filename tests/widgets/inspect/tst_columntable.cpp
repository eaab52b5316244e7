// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"
#include "tests/support/programs/tablecolumns.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"
#include "widgets/inspect/columntable.h"
#include "widgets/inspect/columntablepanel.h"

#include <QTest>
#include <QtWidgets>

namespace tst_columntable {

using namespace pixelplumb;

/// The column table in use: rows chosen, filtered and copied, columns shown and hidden.
class TestColumnTable : public QObject {
    Q_OBJECT

private slots:
    void choosingARowGoesToItsColumn()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTable table(&playhead);

        table.selectRow(rowOf(27));

        QCOMPARE(playhead.currentColumnX(), std::int64_t(27));
        QVERIFY(!playhead.currentPixel());
    }

    void steppingMovesTheCurrentRow()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTable table(&playhead);
        playhead.seekToSpan(std::size_t(rowOf(30)));

        playhead.step(StepUnit::Sample, StepDirection::Forward);
        QCOMPARE(table.currentIndex().row(), rowOf(30));
        QVERIFY(playhead.currentPixel()); // the table did not reset the position

        playhead.step(StepUnit::Span, StepDirection::Forward);
        QCOMPARE(table.currentIndex().row(), rowOf(31));
        QCOMPARE(table.selectionModel()->selectedRows().size(), 1);

        playhead.seek(0);
        QVERIFY(!table.selectionModel()->hasSelection());
    }

    void aClickLeavesTheRowsUnderTheMouse()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTable table(&playhead);
        table.resize(600, 200);
        table.show();
        playhead.seekToSpan(20);
        const int scrolled = table.verticalScrollBar()->value();
        const QRect view = table.viewport()->rect();

        for (const int y : {view.top() + 3, view.bottom() - 3}) {
            const int row = table.rowAt(y);
            QVERIFY(row >= 0);
            QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, {40, y});
            QCOMPARE(playhead.currentSpan(), std::optional(std::size_t(row)));
            QCOMPARE(table.verticalScrollBar()->value(), scrolled);
        }
        playhead.step(StepUnit::Span, StepDirection::Forward); // steps do scroll
        QVERIFY(table.verticalScrollBar()->value() > scrolled);
    }

    void gettingTheFocusDoesNotMoveThePosition()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTable table(&playhead);
        table.show();

        table.setFocus();
        QApplication::setActiveWindow(&table);

        QTRY_VERIFY(table.hasFocus());
        QCOMPARE(playhead.position(), std::size_t(0));
    }

    void copiedRowsAgreeWithTheExportedTrace_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const Arithmetic arithmetic : allArithmetics)
            QTest::newRow(nameOf(arithmetic).data()) << arithmetic;
    }
    void copiedRowsAgreeWithTheExportedTrace()
    {
        QFETCH(const Arithmetic, arithmetic);
        TracedPlayhead playhead(defaultSceneIn(arithmetic));
        ColumnTable table(&playhead);
        for (QAction *action : table.columnActions())
            action->setChecked(true);
        table.selectAll();

        QTest::keySequence(&table, QKeySequence::Copy);

        const QStringList lines
            = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        const auto rows = qsizetype(playhead.traced()->trace->spanCount());
        QCOMPARE(lines.size(), rows + 1);
        const QStringList names = lines[0].split(u'\t');
        const TraceTable<SpanRow> exported = spanTable(playhead.traced()->method->numbers.span);
        const std::vector<Field> &fields = exported.fields();
        for (qsizetype row = 0; row < rows; ++row) {
            const QStringList copied = lines[row + 1].split(u'\t');
            const std::vector<Cell> cells
                = exported.cells(spanRow(*playhead.traced(), std::size_t(row)));
            qsizetype compared = 0;
            for (std::size_t i = 0; i < fields.size(); ++i) {
                const qsizetype place = names.indexOf(fields[i].name);
                if (place < 0)
                    continue;
                QCOMPARE(copied[place], fileText(fields[i], cells[i]));
                ++compared;
            }
            QCOMPARE(compared, names.size());
            QCOMPARE(copied.size(), names.size());
        }
    }

    void theFilterShowsRowsWithTiesClampsAndErrors()
    {
        Scene scene; // y = 2 + (x − 1)/10 below: a tie in every tenth column; float32 misses some
        scene.triangles = {triangleAt(1, 2, 61, 8, 61, 44)};
        scene.settings.arithmetic = Arithmetic::Float32;
        TracedPlayhead playhead(scene);
        const TracedScene &traced = *playhead.traced();
        ColumnTablePanel panel(&playhead);
        auto *box = panel.findChild<QComboBox *>(u"rowFilterBox"_s);
        const auto &model = *qobject_cast<const ColumnTableModel *>(panel.table()->model());
        QCOMPARE(model.rowCount(), 61);
        playhead.seekToSpan(10); // x = 11: a tie

        box->setCurrentIndex(int(RowFilter::Ties));
        QVERIFY(model.rowCount() >= 7 && model.rowCount() < 61);
        QCOMPARE(model.spanAt(panel.table()->currentIndex().row()), std::size_t(10));
        QCOMPARE(panel.findChild<QLabel *>(u"columnTableSummary"_s)->text(),
                 u"%1 of 61 columns"_s.arg(model.rowCount()));
        panel.table()->selectRow(0);
        QCOMPARE(playhead.currentSpan(), std::optional(model.spanAt(0)));
        playhead.seekToSpan(11); // no tie: no row is selected
        QVERIFY(!panel.table()->selectionModel()->hasSelection());

        box->setCurrentIndex(int(RowFilter::Errors));
        QVERIFY(traced.differences.total() > 0);
        for (int x = 1; x <= 61; ++x) {
            bool isWrong = false;
            for (int y = 0; y < scene.frame.height; ++y)
                isWrong = isWrong || traced.differences.at(x, y) != Difference::None;
            const int row = model.rowAt(std::size_t(x - 1));
            QCOMPARE(row < model.rowCount() && model.spanAt(row) == std::size_t(x - 1), isWrong);
        }
        box->setCurrentIndex(int(RowFilter::Clamps));
        QCOMPARE(model.rowCount() > 0, !traced.trace->clampedSamples().empty());
        box->setCurrentIndex(int(RowFilter::All));
        QCOMPARE(model.rowCount(), 61);
    }

    void copiedRowsOfSeveralPrimitivesSayWhose()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact, 2));
        ColumnTablePanel panel(&playhead);
        panel.findChild<QAction *>(u"copyTable"_s)->trigger();
        const QStringList lines
            = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(playhead.traced()->trace->spanCount() + 1));
        const qsizetype column = lines[0].split(u'\t').indexOf("primitive");
        QVERIFY(column >= 0);
        QCOMPARE(lines[1].split(u'\t')[column], "0");
        QCOMPARE(lines.last().split(u'\t')[column], "1");
        panel.table()->selectAll();
        QCOMPARE(panel.table()->selectionAsTsv(), QApplication::clipboard()->text());
    }

    void switchesShowAndHideGroupsOfColumns()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Float32));
        ColumnTablePanel panel(&playhead);
        const ColumnTable &table = *panel.table();
        const auto &model = *qobject_cast<ColumnTableModel *>(table.model());
        const auto isShown
            = [&](const char *name) { return !table.isColumnHidden(columnNamed(model, name)); };
        const auto press = [&](const char *name) {
            panel.findChild<QToolButton *>(QLatin1String(name))->click();
        };

        QVERIFY(!isShown("R_B") && !isShown("R_B_exact") && !isShown("primitive"));
        press("showEdgeColoursButton");
        QVERIFY(isShown("R_B") && !isShown("R_B_exact"));
        press("showExactButton");
        QVERIFY(isShown("R_B_exact") && !isShown("R_B_error"));
        press("showSpanButton");
        QVERIFY(!isShown("y_B") && !isShown("y_B_exact") && isShown("R_B"));

        // The choice survives a new run.
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Float64)));
        QVERIFY(!isShown("y_B") && isShown("R_B_exact"));
    }

    void widthsStayWhileStepping()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
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
};

PIXELPLUMB_TEST(TestColumnTable)

} // namespace tst_columntable

#include "tst_columntable.moc"
