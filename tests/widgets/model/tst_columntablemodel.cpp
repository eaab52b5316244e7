// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/oracle.h"
#include "tests/support/programs/tablecolumns.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/rowsmodel.h"
#include "widgets/model/pixelhistorymodel.h"

#include <QElapsedTimer>
#include <QtTest>

namespace tst_columntablemodel {

using namespace pixelplumb;

class TestColumnTableModel : public QObject {
    Q_OBJECT

private slots:
    void keepsTheModelContractWhileRunsAndPositionsChange()
    {
        Playhead playhead;
        ColumnTableModel model(&playhead);
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);

        for (const Arithmetic arithmetic : allArithmetics) {
            playhead.setTraced(traceScene(defaultSceneIn(arithmetic)));
            playhead.seek(playhead.end());
            playhead.seek(3);
        }
        playhead.setTraced(nullptr);

        QCOMPARE(model.rowCount(), 0);
    }

    void copyingWhereNoCellIsCurrentIsSilent()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTableModel columns(&playhead);
        PixelHistoryModel history;
        RowsModel<int> rows({}, nullptr);
        QTest::failOnWarning(QRegularExpression(QStringLiteral("QModelIndex")));
        for (QAbstractItemModel *model :
             std::initializer_list<QAbstractItemModel *>{&columns, &history, &rows}) {
            QTableView table;
            table.setModel(model);
            table.show();
            QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier); // asks for data of no index
        }
    }

    void hasARowForEachColumnOfAllTriangles()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact, 2));
        ColumnTableModel model(&playhead);

        QCOMPARE(model.rowCount(), 2 * 55); // 4 … 58, twice
        QVERIFY(model.hasSeveralPrimitives());
        QCOMPARE(model.index(55, 0).data(ColumnTableModel::PrimitiveRole).toInt(), 1);
    }

    void showsTheNumbersOfTheTrace()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTableModel model(&playhead);

        // Column 5 is row 1: y_B = 5 + 7/54, y_T = 5 + 39/22.5.
        const auto text = [&](const char *name) {
            return model.index(1, columnNamed(model, name)).data().toString();
        };

        QCOMPARE(text("x"), u"5"_s);
        QCOMPARE(text("half"), u"1"_s);
        QCOMPARE(text("y_B"), u"5\u20097/54"_s);
        QCOMPARE(text("y_T"), u"6\u200911/15"_s);
        QCOMPARE(text("first_row"), u"6"_s);
        QCOMPARE(text("last_row"), u"6"_s);
        QCOMPARE(text("R_B"), u"250\u20095/18"_s); // 255 − 255/54
    }

    void exactArithmeticHasNoColumnsForExactAndError()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTableModel model(&playhead);

        QVERIFY(!model.isRounding());
        QCOMPARE(columnNamed(model, "y_B_exact"), -1);
    }

    void roundedNumbersStandBesideExactOnesAndErrors()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Float32));
        ColumnTableModel model(&playhead);
        const int row = 30;
        const QModelIndex used = model.index(row, columnNamed(model, "y_B"));

        const SpanRecord record = playhead.traced()->trace->span(row);
        const auto exact = oracle::columnAt(playhead.traced()->primitives.triangles[0],
                                            FillRule::Closed, record.place.coordinate);

        QVERIFY(model.isRounding());
        QCOMPARE(used.data().toString(), displayText(record.lower));
        QCOMPARE(model.index(row, columnNamed(model, "y_B_exact")).data().toString(),
                 displayText(exact->yBottom));
        QCOMPARE(model.index(row, columnNamed(model, "y_B_error")).data().toString(),
                 displayError(record.lower, exact->yBottom));
        QVERIFY(used.data(ColumnTableModel::MarkedDigitRole).toInt() > 0);
        QVERIFY(used.data(Qt::ToolTipRole).toString().contains(displayText(exact->yBottom)));
    }

    void marksWhatChangedSinceTheColumnBefore()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTableModel model(&playhead);
        const auto changed = [&](int row, const char *name) {
            return model.index(row, columnNamed(model, name))
                .data(ColumnTableModel::ChangedRole)
                .toBool();
        };

        QVERIFY(!changed(0, "y_B")); // there is no row before it
        QVERIFY(changed(1, "y_B"));
        QVERIFY(!changed(1, "half"));
        QVERIFY(changed(23, "half")); // column 27
        QVERIFY(
            !changed(5, "delta_R")); // exact increments are the plane's, the same in every column
    }

    void marksWhereTrianglesAndHalvesBegin()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact, 2));
        ColumnTableModel model(&playhead);
        const auto mark = [&](int row) {
            return RowMark(model.index(row, 0).data(ColumnTableModel::RowMarkRole).toInt());
        };

        QVERIFY(mark(0) == RowMark::PrimitiveBegins);
        QVERIFY(mark(22) == RowMark::None);
        QVERIFY(mark(23) == RowMark::PartBegins);
        QVERIFY(mark(55) == RowMark::PrimitiveBegins);
        QCOMPARE(model.headerData(55, Qt::Vertical).toString(), u"△ 1"_s);
    }

    void knowsTheCurrentRowAndTheRowsAhead()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        ColumnTableModel model(&playhead);
        QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);

        playhead.seekToSpan(10);

        QVERIFY(changes.count() > 0);
        QVERIFY(model.index(10, 0).data(ColumnTableModel::IsCurrentRole).toBool());
        QVERIFY(!model.index(9, 0).data(ColumnTableModel::IsCurrentRole).toBool());
        QVERIFY(!model.index(10, 0).data(ColumnTableModel::IsAheadRole).toBool());
        QVERIFY(model.index(11, 0).data(ColumnTableModel::IsAheadRole).toBool());
    }

    void computesNothingForRowsThatNobodyAsksFor()
    {
        Scene scene;
        scene.frame.width = 4096;
        scene.frame.height = 4;
        // Wide and flat, many times over: 204800 columns with few pixels each.
        scene.triangles.assign(
            50, {{vertexAt(0, 0, {}), vertexAt(4095, 0, {}), vertexAt(4095, 3, {})}});
        const std::shared_ptr<const TracedScene> traced = traceScene(scene);
        Playhead playhead;
        ColumnTableModel model(&playhead);

        QElapsedTimer timer;
        timer.start();
        playhead.setTraced(traced);
        const int rows = model.rowCount();
        for (int row = rows - 40; row < rows; ++row) {
            for (int column = 0; column < model.columnCount(); ++column)
                QVERIFY(model.index(row, column).data().isValid());
        }

        QCOMPARE(rows, 50 * 4096);
        QVERIFY2(timer.elapsed() < 3000, qPrintable(QString::number(timer.elapsed())));
    }
};

PIXELPLUMB_TEST(TestColumnTableModel)

} // namespace tst_columntablemodel

#include "tst_columntablemodel.moc"
