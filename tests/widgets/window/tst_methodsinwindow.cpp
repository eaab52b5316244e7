// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"
#include "core/methods/words/rejectiontext.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/columntable.h"
#include "widgets/look/messagebar.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/columntablemodel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_methodsinwindow {

using namespace pixelplumb;

namespace {

/// Chooses a method as a user does, by its entry in the box.
void choose(MainWindow &window, const QString &method)
{
    auto *box = named<QComboBox>(window, "methodBox");
    const int row = box->findData(method);
    QVERIFY2(row >= 0, qPrintable(method + u" is not in the box"_s));
    box->setCurrentIndex(row);
    emit box->activated(row);
}

QStringList rowTexts(const MainWindow &window, int row)
{
    const QAbstractItemModel &model = *named<ColumnTable>(window, "columnTable")->model();
    QStringList texts;
    for (int column = 0; column < model.columnCount(); ++column)
        texts.append(model.index(row, column).data(ColumnTableModel::CanonicalTextRole).toString());
    return texts;
}

/// The names in files of the table's columns.
QStringList fileNames(const MainWindow &window)
{
    const auto &model = *qobject_cast<const ColumnTableModel *>(
        named<ColumnTable>(window, "columnTable")->model());
    QStringList names;
    for (int column = 0; column < model.columnCount(); ++column)
        names.append(model.fileName(column));
    return names;
}

} // namespace

/// Every method of the table in the window: chosen, drawn with, stepped.
class TestMethodsInWindow : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void theTableIsCalledAfterWhatTheMethodWalks()
    {
        const auto window = openedWindow();
        const auto *dock = named<QDockWidget>(*window, "columnsDock");
        QCOMPARE(dock->windowTitle(), u"Columns"_s);
        choose(*window, u"row-walk"_s);
        QCOMPARE(dock->windowTitle(), u"Rows"_s);
        QCOMPARE(named<QAction>(*window, "columnsDockToggle")->text(), u"Rows"_s);
        choose(*window, u"column-scan"_s);
        QCOMPARE(dock->windowTitle(), u"Columns"_s);
    }

    void aTriangleIsChangedThoughNoneOfItsVerticesIsSelected()
    {
        const auto window = openedWindow();
        const QAction *change = named<QAction>(*window, "editTriangle");
        QVERIFY(!window->parts().document->selectedVertex());
        QVERIFY(change->isEnabled());
        window->parts().document->clear();
        QVERIFY(!change->isEnabled());
    }

    void twoClicksDrawALineByBresenham()
    {
        const auto window = openedWindow(Scene());
        choose(*window, u"line-bresenham"_s);
        clickPixel(*window, {20, 41});
        clickPixel(*window, {30, 44});

        const SceneDocument &document = *window->parts().document;
        QCOMPARE(document.scene().shapes.size(), std::size_t(1));
        QVERIFY(document.scene().shapes[0].kind == PrimitiveKind::Line);
        const Playhead &playhead = *window->parts().playhead;
        QCOMPARE(playhead.traced()->trace->writtenCount(), std::size_t(11));
        QCOMPARE(playhead.traced()->differences.total(), std::int64_t(0));
        window->parts().document->undoStack()->undo();
        QVERIFY(document.scene().shapes.empty());
        QCOMPARE(document.pendingVertices().size(), std::size_t(1));
        window->parts().document->undoStack()->redo();
        QCOMPARE(document.scene().shapes.size(), std::size_t(1));
    }

    void aPolygonIsClosedByAClickOnItsFirstCorner()
    {
        const auto window = openedWindow(Scene());
        choose(*window, u"polygon-parity"_s);
        for (const QPoint &corner :
             {QPoint(10, 10), QPoint(50, 12), QPoint(40, 40), QPoint(30, 20), QPoint(12, 38)})
            clickPixel(*window, corner);
        const SceneDocument &document = *window->parts().document;
        QVERIFY(document.scene().shapes.empty());
        QCOMPARE(document.pendingVertices().size(), std::size_t(5));
        clickPixel(*window, {10, 10});

        QCOMPARE(document.scene().shapes.size(), std::size_t(1));
        QCOMPARE(document.scene().shapes[0].vertices.size(), std::size_t(5));
        QVERIFY(document.pendingVertices().empty());
        QVERIFY(window->parts().playhead->traced()->trace->writtenCount() > 200);
        QCOMPARE(window->parts().playhead->traced()->differences.total(), std::int64_t(0));
    }

    void aCircleStaysRoundWhenItsCornerIsDragged()
    {
        const auto window = openedWindow(Scene());
        choose(*window, u"circle-midpoint"_s);
        clickPixel(*window, {32, 24});
        clickPixel(*window, {40, 30});
        SceneDocument &document = *window->parts().document;
        QCOMPARE(document.scene().shapes.size(), std::size_t(1));
        QCOMPARE(document.vertexAt({0, 1})->position, latticePixel(40, 32));
        document.moveVertex({0, 1}, latticePixel(37, 44), document.newDrag());
        QCOMPARE(document.vertexAt({0, 1})->position, latticePixel(52, 44));
        document.moveVertex({0, 0}, latticePixel(30, 20), document.newDrag());
        QCOMPARE(document.vertexAt({0, 1})->position, latticePixel(50, 40));
        document.undoStack()->undo();
        document.undoStack()->undo();
        QCOMPARE(document.vertexAt({0, 1})->position, latticePixel(40, 32));
    }

    void choosingAMethodThatDoesNotKeepTheFillRuleTakesOneThatItKeepsAndSaysSo()
    {
        Scene scene;
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        const auto window = openedWindow(scene);
        const QRect canvas = window->parts().canvas->geometry();
        choose(*window, u"row-walk"_s);

        const MessageBar &bar = *window->parts().messageBar;
        QVERIFY(bar.isVisible());
        QCOMPARE(named<QLabel>(bar, "messageKind")->text(), u"Note"_s);
        QVERIFY2(bar.text().startsWith(methodNamed(u"row-walk")->title), qPrintable(bar.text()));
        QVERIFY2(!bar.text().contains("row-walk"), qPrintable(bar.text()));
        QCOMPARE(window->parts().canvas->geometry(), canvas);
        choose(*window, u"barycentric-all"_s);
        QVERIFY(!bar.isVisible());
        window->parts().document->undoStack()->undo();
        const Scene &drawn = window->parts().document->scene();
        QCOMPARE(drawn.method, std::string("row-walk"));
        QVERIFY(methodNamed(u"row-walk")->supports(drawn.settings.fillRule));
        window->parts().document->undoStack()->undo();
        QCOMPARE(window->parts().document->scene(), scene);
    }

    void aSceneOfAnotherKindNamesAMethodThatDrawsIt_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("drawing"); ///< a method that draws these primitives
        QTest::newRow("triangle by a line's method") << "default.json"
                                                     << "line-bresenham"
                                                     << "column-scan";
        QTest::newRow("lines by a triangle's method") << "lines.json"
                                                      << "column-scan"
                                                      << "line-dda";
    }
    void aSceneOfAnotherKindNamesAMethodThatDrawsIt()
    {
        QFETCH(QString, file);
        QFETCH(QString, method);
        QFETCH(QString, drawing);
        const auto window = openedWindow(file);
        QVERIFY(foreignSceneHint(window->parts().document->scene()).isEmpty());

        choose(*window, method);

        const QString hint = foreignSceneHint(window->parts().document->scene());
        QVERIFY2(hint.contains(methodNamed(method)->title), qPrintable(hint));
        QVERIFY2(hint.contains(methodNamed(drawing)->title), qPrintable(hint));
        const QString sentence = named<QLabel>(*window, "formulaSentence")->text();
        QVERIFY2(sentence.contains(hint.left(20)), qPrintable(sentence));
    }

    void whatTheKernelRejectsIsSaidWithItsReason()
    {
        Scene scene;
        scene.method = "line-slope-intercept";
        Shape line;
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(5, 2), {}}, {latticePixel(5, 9), {}}};
        scene.shapes = {line};
        const auto window = openedWindow(scene);
        const QString reason = rejectionText(PrimitiveRejection::VerticalLine);

        const MessageBar &bar = *window->parts().messageBar;
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.text(), u"Line 0: "_s + reason);
        window->parts().playhead->pick({5, 4});
        const QString said = named<QLabel>(*window, "pixelHistoryReason")->text();
        QVERIFY2(said.startsWith("Missing") && said.endsWith(typesetHtml(reason)),
                 qPrintable(said));
        window->parts().document->moveVertex({0, 1}, latticePixel(9, 9), 1);
        QVERIFY(!bar.isVisible());
    }

    void steppingARowMethodGoesByRowsAndSaysSo()
    {
        Scene scene;
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
        scene.method = "row-walk";
        const auto window = openedWindow(scene);
        Playhead &playhead = *window->parts().playhead;
        playhead.seek(1); // the set-up is done
        playhead.step(StepUnit::Span, StepDirection::Forward);
        QVERIFY(playhead.currentPlace().has_value());
        QVERIFY(playhead.currentPlace()->axis == SpanAxis::Row);
        // The edge walk goes down from the top.
        QCOMPARE(playhead.currentPlace()->coordinate, std::int64_t(44));
        QCOMPARE(action(*window, "nextColumn")->iconText(), u"row"_s);
        QCOMPARE(named<QLabel>(*window, "statusColumn")->text(), u"row 44, first trapezoid"_s);
    }

    void theTableAgreesWithTheExportUnderEveryMethod_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods()) {
            if (method.draws(PrimitiveKind::Triangle))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void theTableAgreesWithTheExportUnderEveryMethod()
    {
        QFETCH(QString, method);
        Scene scene;
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
        scene.method = method.toStdString();
        scene.settings = methodNamed(method)->adapted({});
        const auto window = openedWindow(scene);
        const TracedScene &traced = *window->parts().playhead->traced();
        QVERIFY(traced.trace->spanCount() > 0);
        for (const std::size_t span : {std::size_t(0), traced.trace->spanCount() / 2}) {
            const TraceTable<SpanRow> table
                = spanTable(traced.method->numbers.span).only(fileNames(*window));
            const std::vector<Cell> cells = table.cells(spanRow(traced, span));
            QStringList exported;
            for (std::size_t i = 0; i < cells.size(); ++i)
                exported.append(fileText(table.fields()[i], cells[i]));
            QCOMPARE(rowTexts(*window, int(span)), exported);
        }
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestMethodsInWindow)

} // namespace tst_methodsinwindow

#include "tst_methodsinwindow.moc"
