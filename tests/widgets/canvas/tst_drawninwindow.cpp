// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/framespec.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/stepping/scrubber.h"

#include <QTest>
#include <QtWidgets>

namespace tst_drawninwindow {

using namespace pixelplumb;

namespace {

/// An empty scene whose samples are at pixel centres, or at pixel corners.
Scene emptyScene(PixelCentre centre)
{
    Scene scene;
    scene.frame = frameOf(64, 48);
    scene.frame.pixelCentre = centre;
    return scene;
}

void press(const MainWindow &window, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    QTest::keyClick(window.parts().canvas, key, modifiers);
}

void hover(Canvas &canvas, const QPointF &position)
{
    QMouseEvent move(QEvent::MouseMove, position, canvas.mapToGlobal(position), Qt::NoButton,
                     Qt::NoButton, {});
    QCoreApplication::sendEvent(&canvas, &move);
}

/// "pixel (27, 19)", without the colour.
QString pixelInStatusBar(const MainWindow &window)
{
    return named<QLabel>(window, "statusPixel")->text().section(u' ', 0, 2);
}

QString pixelText(const QPoint &pixel) { return u"pixel (%1, %2)"_s.arg(pixel.x()).arg(pixel.y()); }

} // namespace

/// What the window reports about shapes that a user draws on the canvas.
class TestDrawnInWindow : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aVertexWaitsOnUnderAMethodThatDrawsTheSameKind()
    {
        const auto window = openedWindow(emptyScene(PixelCentre::Integer));
        const SceneDocument &document = *window->parts().document;
        clickPixel(*window, {4, 5});
        press(*window, Qt::Key_2);
        QVERIFY(document.scene().method != "column-scan");
        QCOMPARE(document.pendingVertices().size(), std::size_t(1));
        QVERIFY(window->statusBar()->currentMessage().isEmpty());

        press(*window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document.scene().method, std::string("column-scan"));
        QCOMPARE(document.pendingVertices().size(), std::size_t(1));

        press(*window, Qt::Key_2);
        clickPixel(*window, {58, 12});
        clickPixel(*window, {26, 44});
        QCOMPARE(document.scene().triangles.size(), std::size_t(1));
        QCOMPARE(document.scene().triangles[0].vertices[0].position, latticePixel(4, 5));
    }

    void verticesThatAnotherKindDropsAreToldOfAndUndoBringsThemBack()
    {
        const auto window = openedWindow(emptyScene(PixelCentre::Integer));
        SceneDocument &document = *window->parts().document;
        clickPixel(*window, {4, 5});
        clickPixel(*window, {58, 12});
        const std::vector<Vertex> waiting = document.pendingVertices();
        document.setMethod("line-bresenham");
        QVERIFY(document.pendingVertices().empty());
        QCOMPARE(
            window->statusBar()->currentMessage(),
            u"2 waiting vertices dropped: “Line: Bresenham” draws another kind of primitive. Undo "
            "brings them back."_s);

        press(*window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document.scene().method, std::string("column-scan"));
        QCOMPARE(document.pendingVertices(), waiting);
        press(*window, Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(document.pendingVertices().empty());
    }

    void thePanelsExplainTheLastPixelOfATriangleThatWasJustDrawn()
    {
        const auto window = openedWindow();
        press(*window, Qt::Key_N, Qt::ControlModifier);
        const Playhead &playhead = *window->parts().playhead;
        QVERIFY(!playhead.pickedPixel());
        for (const QPoint &vertex : {QPoint(0, 0), QPoint(5, 5), QPoint(5, 0)})
            clickPixel(*window, vertex);

        QCOMPARE(playhead.position(), playhead.end());
        QCOMPARE(playhead.pickedPixel(), std::optional(QPoint(5, 5)));
        const auto *grid = named<PixelGrid>(*window, "pixelGrid");
        QTRY_COMPARE(grid->pixelAt(QRectF(grid->mapping().devicePicture()).center()
                                   / grid->devicePixelRatioF()),
                     std::optional(QPoint(5, 5)));
    }

    void theStatusBarNamesThePixelUnderThePointerThatRests_data()
    {
        QTest::addColumn<PixelCentre>("centre");
        QTest::newRow("samples on whole numbers") << PixelCentre::Integer;
        QTest::newRow("samples on halves") << PixelCentre::Half;
    }
    void theStatusBarNamesThePixelUnderThePointerThatRests()
    {
        QFETCH(PixelCentre, centre);
        const auto window = openedWindow(emptyScene(centre));
        Canvas &canvas = *window->parts().canvas;
        for (const double share : {0.1, 0.45, 0.55, 0.9}) { // of a pixel's cell
            press(*window, Qt::Key_0, Qt::ControlModifier);
            canvas.zoomIn();
            canvas.zoomIn();
            const double cell
                = canvas.positionOf(QPoint(1, 0)).x() - canvas.positionOf(QPoint(0, 0)).x();
            const QPointF rest = canvas.positionOf(QPoint(30, 20))
                + QPointF(cell * (share - 0.5), cell * (share - 0.5));
            hover(canvas, rest);
            const QPoint before = *canvas.pixelAt(rest);
            QCOMPARE(pixelInStatusBar(*window), pixelText(before));

            press(*window, Qt::Key_0, Qt::ControlModifier);
            QVERIFY(canvas.pixelAt(rest) != before);
            QCOMPARE(pixelInStatusBar(*window), pixelText(*canvas.pixelAt(rest)));
        }
    }

    void theScrubberGoesToTheRowsAndColumnsOfAllVerticesInEveryMethod_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods()) {
            if (method.draws(PrimitiveKind::Triangle))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void theScrubberGoesToTheRowsAndColumnsOfAllVerticesInEveryMethod()
    {
        QFETCH(QString, method);
        Scene scene = emptyScene(PixelCentre::Integer);
        scene.method = method.toStdString();
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44), triangleAt(10, 30, 20, 8, 40, 20)};
        const auto window = openedWindow(scene);
        Scrubber &scrubber = *window->parts().scrubber;
        const Playhead &playhead = *window->parts().playhead;
        const SpanAxis axis = playhead.traced()->trace->placeOf(0).axis;
        if (axis == SpanAxis::Free)
            QSKIP("It walks neither columns nor rows.");
        const std::vector<TraceMark> &marks = playhead.traced()->marks;
        std::array<std::set<std::int64_t>, 2> reached;
        for (const TraceMark &mark : marks) {
            if (mark.kind != MarkKind::PartBegins)
                continue;
            const double x = scrubber.scale().xOf(mark.step + 1);
            QVERIFY(scrubber.markNear(x));
            const TraceStep step = playhead.traced()->trace->stepAt(mark.step);
            reached[step.primitive].insert(playhead.traced()->trace->placeOf(step.span).coordinate);
        }
        for (std::size_t triangle = 0; triangle < reached.size(); ++triangle) {
            for (const Vertex &vertex :
                 playhead.traced()->primitives.triangles[triangle].vertices) {
                const std::int64_t along
                    = floorPixel(axis == SpanAxis::Row ? vertex.position.y : vertex.position.x);
                QVERIFY2(reached[triangle].contains(along),
                         qPrintable(u"triangle %1, %2"_s.arg(triangle).arg(along)));
            }
        }
    }

    void theSlidesExampleEdgeStandsInTheFormulasOfItsTriangle_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QStringList>("numbers"); // a₀, b₀, c₀: −2x − y + 2, and multiplied by k =
                                                  // ½
        QTest::newRow("F") << "edge-equations" << QStringList{"−2", "−1", "2"};
        QTest::newRow("F′") << "edge-equations-solved" << QStringList{"−1", "−1/2", "1"};
    }
    void theSlidesExampleEdgeStandsInTheFormulasOfItsTriangle()
    {
        QFETCH(QString, method);
        QFETCH(QStringList, numbers);
        Scene scene;
        scene.frame = frameOf(16, 12);
        scene.method = method.toStdString();
        const auto window = openedWindow(scene);
        for (const QPoint &vertex : {QPoint(0, 2), QPoint(1, 0), QPoint(0, 0)})
            clickPixel(*window, vertex);
        action(*window, "runToStart")->trigger();
        action(*window, "nextPixel")->trigger();

        QCOMPARE(window->parts().playhead->position(), std::size_t(1));
        const QString text = named<QTextBrowser>(*window, "formulaText")->toPlainText();
        for (qsizetype i = 0; i < numbers.size(); ++i) {
            const QRegularExpression line(u"%1₀ = [^\\n]*\\n%2\\n"_s.arg(u"abc"_s[i], numbers[i]));
            QVERIFY2(line.match(text).hasMatch(), qPrintable(line.pattern() + u'\n' + text));
        }
    }

    void theSlidesTablesStandBelowTheCanvas_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("heading");
        QTest::addColumn<QStringList>("numbers"); // from the first row on
        QTest::newRow("Example") << "lines.json"
                                 << "line-slope-intercept"
                                 << "y_r" << QStringList{"41", "41", "42", "42", "42", "43",
                                                         "43", "43", "43", "44", "44"};
        QTest::newRow("Example 2") << "steep-line.json"
                                   << "line-slope-intercept"
                                   << "y_r" << QStringList{"41", "46"};
        QTest::newRow("Bresenham: Example")
            << "lines.json"
            << "line-bresenham"
            << "p_k" << QStringList{"", "−4", "2", "−12", "−6", "0", "−14", "−8", "−2", "4", "−10"};
    }
    void theSlidesTablesStandBelowTheCanvas()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(QString, heading);
        QFETCH(QStringList, numbers);
        const auto window = openedWindow(scene);
        window->parts().document->setMethod(method.toStdString());
        const auto *table = named<QTableView>(*window, "columnTable");
        const QAbstractItemModel &model = *table->model();
        QTRY_VERIFY(model.rowCount() >= numbers.size());
        int column = 0;
        QStringList headings;
        for (; column < model.columnCount(); ++column) {
            headings += model.headerData(column, Qt::Horizontal).toString();
            if (headings.last() == heading)
                break;
        }
        QVERIFY2(column < model.columnCount(), qPrintable(headings.join(u'|')));
        QVERIFY(!table->isColumnHidden(column));
        QStringList shown;
        for (int row = 0; row < numbers.size(); ++row)
            shown += model.index(row, column).data().toString();
        QCOMPARE(shown, numbers);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestDrawnInWindow)

} // namespace tst_drawninwindow

#include "tst_drawninwindow.moc"
