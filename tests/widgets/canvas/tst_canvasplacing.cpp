// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"
#include "widgets/dialogs/triangledialog.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_canvasplacing {

using namespace pixelplumb;

/// Vertices placed, moved and coloured by hand.
class TestCanvasPlacing : public QObject {
    Q_OBJECT

private slots:
    void placesAVertexAtThePixelUnderTheClick_data()
    {
        QTest::addColumn<int>("zoom");
        for (const int zoom : {4, 5, 9, 16, 64})
            QTest::addRow("zoom %d", zoom) << zoom;
    }
    void placesAVertexAtThePixelUnderTheClick()
    {
        QFETCH(int, zoom);
        CanvasBench bench;
        bench.canvas.setZoom(zoom);
        QCOMPARE(bench.canvas.zoom(), zoom);
        const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center() + QPointF(9, -13));

        bench.click(pixel.x(), pixel.y());

        QCOMPARE(bench.document.pendingVertices().at(0).position,
                 latticePixel(pixel.x(), pixel.y()));
    }

    void threeClicksDrawATriangle()
    {
        CanvasBench bench;
        bench.click(4, 5);
        bench.click(58, 12);
        QCOMPARE(bench.document.pendingVertices().size(), 2U);
        bench.click(26, 44);

        QCOMPARE(bench.document.scene().triangles, firstScene().triangles);
        bench.document.undoStack()->undo();
        QCOMPARE(bench.document.pendingVertices().size(), 2U);
        bench.document.undoStack()->redo();
        QCOMPARE(bench.document.scene().triangles, firstScene().triangles);
    }

    void dragsAVertexInOneCommand()
    {
        CanvasBench bench(firstScene());
        const int commands = bench.document.undoStack()->count();

        bench.drag(bench.at(58, 12), bench.at(50, 30));

        QCOMPARE(bench.vertex(0, 1), latticePixel(50, 30));
        QCOMPARE(bench.document.undoStack()->count(), commands + 1);
        bench.document.undoStack()->undo();
        QCOMPARE(bench.document.scene(), firstScene());
    }

    void anEdgeIsSharedByClicksOnItsVertices()
    {
        CanvasBench bench(firstScene());
        bench.click(50, 40);
        bench.click(26, 44);
        bench.click(58, 12);

        QCOMPARE(bench.document.scene().triangles.size(), 2U);
        QCOMPARE(bench.vertex(1, 0), latticePixel(50, 40));
        QCOMPARE(bench.vertex(1, 1), bench.vertex(0, 2)); // the vertex's place, not the click's
        QCOMPARE(bench.vertex(1, 2), bench.vertex(0, 1));
        QVERIFY(bench.document.pendingVertices().empty());
    }

    void aSecondClickOnASelectedVertexPlacesOneThere()
    {
        CanvasBench bench(firstScene());
        bench.click(26, 44);
        QCOMPARE(bench.document.selectedVertex(), std::optional(VertexRef{0, 2}));
        QVERIFY(bench.document.pendingVertices().empty());
        QVERIFY(!bench.document.isModified());
        bench.click(26, 44);
        QCOMPARE(bench.document.pendingVertices().size(), 1U);
        QCOMPARE(bench.document.pendingVertices().front().position, bench.vertex(0, 2));
        bench.click(26, 44);
        bench.click(26, 44);
        QCOMPARE(bench.document.scene().triangles.size(), 2U); // without area
    }

    void escapeEndsADragWithoutATrace()
    {
        CanvasBench bench(firstScene());
        bench.send(QEvent::MouseButtonPress, bench.at(4, 5), Qt::LeftButton, Qt::LeftButton);
        bench.send(QEvent::MouseMove, bench.at(10, 10), Qt::NoButton, Qt::LeftButton);
        QCOMPARE(bench.vertex(0, 0), latticePixel(10, 10));

        QTest::keyClick(&bench.canvas, Qt::Key_Escape);
        bench.send(QEvent::MouseButtonRelease, bench.at(10, 10), Qt::LeftButton, {});

        QCOMPARE(bench.document.scene(), firstScene());
        QVERIFY(!bench.document.isModified());
    }

    void escapeDiscardsPendingVertices()
    {
        CanvasBench bench;
        bench.click(4, 5);
        bench.click(20, 12);

        QTest::keyClick(&bench.canvas, Qt::Key_Escape);
        QVERIFY(bench.document.pendingVertices().empty());
        QVERIFY(!bench.document.isModified());
        QVERIFY(!bench.document.undoStack()->canUndo());
        bench.document.undoStack()->redo();
        QCOMPARE(bench.document.pendingVertices().size(), 1U);
        QVERIFY(bench.document.isModified());
    }

    void clicksSnapToSixteenths()
    {
        CanvasBench bench;
        bench.canvas.setZoom(64);
        bench.document.setSnap(Snap::Sixteenth);
        const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center());
        // A quarter pixel to the right of the sample and three sixteenths above it.
        const LatticePoint point{pixel.x() * unitsPerPixel + 64, pixel.y() * unitsPerPixel + 48};

        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {},
                          bench.canvas.positionOf(point).toPoint());

        QCOMPARE(bench.document.pendingVertices().at(0).position, point);
    }

    void handlesOfAPolygonHaveItsColour()
    {
        CanvasBench bench;
        SceneDocument &document = bench.document;
        document.setMethod("polygon-parity");
        const Colour violet{{136, 0, 255}};
        const auto coloursOf = [](const std::vector<Vertex> &vertices) {
            std::vector<Colour> colours;
            for (const Vertex &vertex : vertices)
                colours.push_back(vertex.colour);
            return colours;
        };
        bench.click(4, 5);
        bench.click(20, 12);
        QCOMPARE(coloursOf(document.pendingVertices()), std::vector(2, Colour{{255, 0, 0}}));
        document.setNextColour(violet);
        bench.click(9, 20);
        QCOMPARE(coloursOf(document.pendingVertices()), std::vector(3, violet));
        document.closePending();
        QCOMPARE(coloursOf(document.verticesOf(0)), std::vector(3, violet));

        document.setVertexColour({0, 2}, Colour{{0, 255, 0}}); // through any of its handles
        QCOMPARE(coloursOf(document.verticesOf(0)), std::vector(3, Colour{{0, 255, 0}}));
    }

    void halfPixelCentresKeepTheScenesCoordinates()
    {
        Scene scene;
        scene.frame.origin = FrameOrigin::TopLeft;
        scene.frame.pixelCentre = PixelCentre::Half;
        CanvasBench bench(scene);
        const LatticePoint corner = latticePixel(10, 20);

        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {},
                          bench.canvas.positionOf(corner).toPoint());

        // The corner that the pixels (9, 19) and (10, 20) share.
        QCOMPARE(bench.document.pendingVertices().at(0).position, corner);
        const QPointF between
            = (bench.canvas.positionOf(QPoint(9, 19)) + bench.canvas.positionOf(QPoint(10, 20)))
            / 2;
        // Each of the two middles may be one device pixel too far to the upper left.
        QVERIFY((bench.canvas.positionOf(corner) - between).manhattanLength() <= 2);
    }

    void rightClickPicksThePixelAndOnAHandleOpensItsMenu()
    {
        CanvasBench bench(firstScene());
        QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);
        bench.click(30, 20, Qt::RightButton);
        QCOMPARE(bench.playhead.pickedPixel(), std::optional(QPoint(30, 20)));
        QVERIFY(!bench.document.isModified());
        bench.click(58, 12, Qt::RightButton);
        auto *menu = bench.canvas.findChild<QMenu *>(u"canvasMenu"_s);
        QVERIFY(menu);
        QCOMPARE(bench.document.selectedVertex(), std::optional(VertexRef{0, 1}));

        menu->actions().first()->trigger();
        QCOMPARE(colourRequested.at(0).at(0).value<VertexRef>(), (VertexRef{0, 1}));
        menu->actions().last()->trigger();
        QVERIFY(bench.document.scene().triangles.empty());
        menu->close();
    }

    void doubleClickOnAHandleAsksForAColour()
    {
        CanvasBench bench(firstScene());
        QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);

        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.at(58, 12));
        bench.send(QEvent::MouseButtonDblClick, bench.at(58, 12), Qt::LeftButton, Qt::LeftButton);
        bench.send(QEvent::MouseButtonRelease, bench.at(58, 12), Qt::LeftButton, {});

        QCOMPARE(colourRequested.count(), 1);
        QVERIFY(!bench.document.isModified());
    }

    void doubleClickOnAnEmptyPlacePlacesVertices()
    {
        CanvasBench bench;
        QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);
        bench.click(10, 10);
        bench.send(QEvent::MouseButtonDblClick, bench.at(10, 10), Qt::LeftButton, Qt::LeftButton);
        bench.send(QEvent::MouseButtonRelease, bench.at(10, 10), Qt::LeftButton, {});
        QCOMPARE(colourRequested.count(), 0); // the second click hits the new vertex

        bench.send(QEvent::MouseButtonDblClick, bench.at(30, 10), Qt::LeftButton, Qt::LeftButton);
        bench.send(QEvent::MouseButtonRelease, bench.at(30, 10), Qt::LeftButton, {});
        QCOMPARE(bench.document.pendingVertices().size(), 2U);
    }

    void coordinatesCanBeTyped()
    {
        CanvasBench bench(firstScene());
        QSignalSpy refused(&bench.document, &SceneDocument::refused);
        for (const char *typed : {"53/; 44", "53/2", "53/2; 44"}) {
            bench.canvas.editCoordinates({0, 2});
            auto *dialog = bench.canvas.findChild<QInputDialog *>(u"vertexDialog"_s);
            dialog->setTextValue(QString::fromLatin1(typed));
            dialog->accept();
            delete dialog;
        }
        QCOMPARE(refused.count(), 2);

        QCOMPARE(bench.vertex(0, 2), (LatticePoint{53 * 128, 44 * 256}));
    }

    void whatATriangleCarriesCanBeTyped()
    {
        CanvasBench bench(firstScene());
        SceneDocument &document = bench.document;
        TriangleDialog dialog({document.scene().triangles.front(), document.attributesOf(0)});
        const auto type = [&dialog](const char *field, const QString &text) {
            dialog.findChild<QLineEdit *>(QLatin1String(field))->setText(text);
        };
        const auto take = [&] {
            const TypedTriangle typed = *dialog.triangle();
            document.setTriangle(0, typed.triangle, typed.attributes);
        };
        QCOMPARE(dialog.triangle()->triangle, document.scene().triangles.front());
        take();
        QVERIFY(!document.isModified()); // nothing was typed

        type("vertex1z", u"1/4"_s);
        type("vertex2u", u"-0.5"_s);
        take();
        QCOMPARE(document.scene().attributes.size(), 1U);
        QCOMPARE(document.attributesOf(0).vertices[1].z, attributeOne / 4);
        QCOMPARE(document.attributesOf(0).vertices[2].texture[0], -attributeOne / 2);
        QCOMPARE(readScene(writeScene(document.scene(), {}))->scene, document.scene());

        type("vertex0w", u"0"_s);
        QVERIFY(!dialog.triangle());
        QCOMPARE(dialog.triangle().error().place, u"vertex 0, w"_s);
        type("vertex0w", {});
        type("vertex0N_z", u"1"_s);
        QVERIFY(!dialog.triangle()); // only one of three normals
        QVERIFY(dialog.triangle().error().message().contains(u"three normals"_s));
        type("vertex0N_z", {});
        type("vertex1z", {});
        type("vertex2u", {});
        take();
        QVERIFY(document.scene().attributes.empty()); // default values are not kept
        document.undoStack()->undo();
        QCOMPARE(document.attributesOf(0).vertices[1].z, attributeOne / 4);
    }
};

PIXELPLUMB_TEST(TestCanvasPlacing)

} // namespace tst_canvasplacing

#include "tst_canvasplacing.moc"
