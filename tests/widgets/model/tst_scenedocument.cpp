// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>

namespace tst_scenedocument {

using namespace pixelplumb;

namespace {

constexpr Colour yellow = {{255, 255, 0}};

/// A triangle shifted this many pixels to the right.
Triangle triangle(std::int64_t shift) { return triangleAt(shift, 0, shift + 4, 0, shift, 4); }

/// A triangle, a sphere and a point, with a light.
Scene sceneInSpace()
{
    Scene scene;
    scene.triangles = {triangle(0)};
    scene.camera = Camera();
    Solid sphere;
    sphere.kind = SolidKind::Sphere;
    sphere.corners = {{{0, 0, 0}}};
    scene.solids = {sphere};
    Shape point;
    point.kind = PrimitiveKind::Point;
    point.vertices = {{latticePixel(3, 3), red}};
    scene.shapes = {point};
    scene.appearance.lights = {Light{Light::Kind::Directional, {attributeOne, 0, 0}}};
    return scene;
}

} // namespace

/// Vertices, frames and the selection of a document, and the edits that it refuses.
class TestSceneDocument : public QObject {
    Q_OBJECT

private slots:
    void everyThirdVertexCompletesATriangle()
    {
        SceneDocument document;
        QSignalSpy sceneChanged(&document, &SceneDocument::sceneChanged);
        document.placeVertex(latticePixel(1, 2));
        document.placeVertex(latticePixel(9, 3));
        QCOMPARE(document.pendingVertices().size(), 2U);
        QCOMPARE(sceneChanged.count(), 0);

        document.placeVertex(latticePixel(5, 8));

        const Triangle expected{
            {{{latticePixel(1, 2), red}, {latticePixel(9, 3), green}, {latticePixel(5, 8), blue}}}};
        QCOMPARE(document.scene().triangles, std::vector{expected});
        QVERIFY(document.pendingVertices().empty());
        QCOMPARE(sceneChanged.count(), 1);
    }

    void defaultColoursAreRedGreenAndBlue()
    {
        SceneDocument document;
        for (int round = 0; round < 2; ++round) {
            for (const Colour &expected : {red, green, blue}) {
                QCOMPARE(document.nextColour(), expected);
                document.placeVertex(latticePixel(round, round));
            }
        }
    }

    void aChosenColourIsForTheNextVertexAlone()
    {
        SceneDocument document;
        document.placeVertex(latticePixel(1, 2));
        document.setNextColour(yellow);
        document.placeVertex(latticePixel(9, 3));

        QCOMPARE(document.pendingVertices()[1].colour, yellow);
        QCOMPARE(document.nextColour(), blue);
    }

    void refusesPositionsBeyondTheRange_data()
    {
        QTest::addColumn<Lattice>("x");
        QTest::addColumn<bool>("accepted");
        QTest::newRow("2^30 px") << largestCoordinate << true;
        QTest::newRow("2^30 px and 1/256") << largestCoordinate + 1 << false;
        QTest::newRow("-2^30 px") << -largestCoordinate << true;
        QTest::newRow("-2^30 px and 1/256 less") << -largestCoordinate - 1 << false;
    }
    void refusesPositionsBeyondTheRange()
    {
        QFETCH(Lattice, x);
        QFETCH(bool, accepted);
        SceneDocument document;
        document.addTriangle(triangle(0));
        QSignalSpy refused(&document, &SceneDocument::refused);

        document.placeVertex({x, 0});
        document.moveVertex({0, 0}, {0, x}, 1);

        QCOMPARE(document.pendingVertices().size(), accepted ? 1U : 0U);
        QCOMPARE(document.vertexAt({0, 0})->position.y, accepted ? x : 0);
        QCOMPARE(refused.count(), accepted ? 0 : 2);
        if (!accepted)
            QVERIFY(refused[0][0].toString().contains("2^30"));
    }

    void refusesFramesThatCannotBeMade_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<bool>("accepted");
        QTest::newRow("1 by 1") << 1 << 1 << true;
        QTest::newRow("no column") << 0 << 10 << false;
        QTest::newRow("no row") << 10 << 0 << false;
        QTest::newRow("widest") << 32768 << 1 << true;
        QTest::newRow("too wide") << 32769 << 1 << false;
        QTest::newRow("sides allowed, area not") << 32768 << 32768 << false;
    }
    void refusesFramesThatCannotBeMade()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(bool, accepted);
        SceneDocument document;
        QSignalSpy refused(&document, &SceneDocument::refused);

        document.setFrame(frameOf(width, height));

        QCOMPARE(document.scene().frame.width == width && document.scene().frame.height == height,
                 accepted);
        QCOMPARE(refused.count(), accepted ? 0 : 1);
    }

    void refusesAMethodThatDoesNotExist()
    {
        SceneDocument document;
        QSignalSpy refused(&document, &SceneDocument::refused);

        document.setMethod("no-such-method");

        QCOMPARE(document.scene().method, std::string("column-scan"));
        QVERIFY(refused.at(0).at(0).toString().contains("no-such-method"));
    }

    void selectionFollowsItsVertex()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        document.addTriangle(triangle(10));
        document.selectVertex(VertexRef{1, 2});

        document.deletePrimitive(0);
        QCOMPARE(document.selectedVertex(), std::optional(VertexRef{0, 2}));
        document.undoStack()->undo();
        QCOMPARE(document.selectedVertex(), std::optional(VertexRef{1, 2}));

        document.placeVertex(latticePixel(1, 1));
        document.selectVertex(VertexRef{VertexRef::pending, 0});
        document.placeVertex(latticePixel(2, 1));
        document.placeVertex(latticePixel(2, 2));
        QCOMPARE(document.selectedVertex(), std::optional(VertexRef{2, 0}));
    }

    void selectionGoesWithItsTriangle()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        document.selectVertex(VertexRef{0, 1});
        QSignalSpy selectionChanged(&document, &SceneDocument::selectionChanged);

        document.deleteVertex({0, 1});

        QVERIFY(!document.selectedVertex());
        QCOMPARE(selectionChanged.count(), 1);
    }

    void snapsToTheChosenLattice_data()
    {
        QTest::addColumn<Snap>("snap");
        QTest::addColumn<Lattice>("x");
        QTest::addColumn<Lattice>("expected");
        // In units of 1/256 px; a sixteenth of a pixel is 16 of them.
        QTest::newRow("pixel, down") << Snap::Pixel << Lattice(256 + 127) << Lattice(256);
        QTest::newRow("pixel, the middle goes up")
            << Snap::Pixel << Lattice(256 + 128) << Lattice(512);
        QTest::newRow("pixel, negative") << Snap::Pixel << Lattice(-129) << Lattice(-256);
        QTest::newRow("sixteenth") << Snap::Sixteenth << Lattice(25) << Lattice(32);
        QTest::newRow("the lattice itself") << Snap::Finest << Lattice(25) << Lattice(25);
    }
    void snapsToTheChosenLattice()
    {
        QFETCH(Snap, snap);
        QFETCH(Lattice, x);
        QFETCH(Lattice, expected);
        SceneDocument document;
        document.setSnap(snap);

        QCOMPARE(document.snapped({x, -x}).x, expected);
    }

    void editsOfTheFrameKeepWhatStandsInSpace()
    {
        SceneDocument document;
        const Scene scene = sceneInSpace();
        document.reset(scene);
        QCOMPARE(document.primitiveCount(), 2);
        QCOMPARE(document.kindOf(1), PrimitiveKind::Point);

        document.addTriangle(triangle(5));
        document.moveVertex({2, 0}, latticePixel(9, 9), document.newDrag());
        document.deletePrimitive(0);
        QCOMPARE(document.scene().shapes[0].vertices[0].position, latticePixel(9, 9));
        QCOMPARE(document.scene().triangles, std::vector{triangle(5)});
        QCOMPARE(document.scene().solids, scene.solids);
        QCOMPARE(document.scene().camera, scene.camera);
        QCOMPARE(document.scene().appearance, scene.appearance);

        document.undoStack()->setIndex(0);
        QCOMPARE(document.scene(), scene);
    }

    void changesInSpaceAreEdits()
    {
        SceneDocument document;
        const Scene scene = sceneInSpace();
        document.reset(scene);
        Solid sphere = scene.solids[0];
        const int drag = document.newDrag();
        for (const int around : {20, 24}) {
            sphere.segments[0] = around;
            document.setSolid(0, sphere, drag);
        }
        document.setSolid(7, sphere, document.newDrag()); // there is no such solid
        Appearance flat = scene.appearance;
        flat.shading = Shading::Flat;
        document.setAppearance(flat);
        QCOMPARE(document.undoStack()->count(), 2); // one drag is one edit
        QCOMPARE(document.scene().solids[0].segments[0], 24);
        QCOMPARE(document.scene().appearance.shading, Shading::Flat);

        document.undoStack()->undo();
        document.undoStack()->undo();
        QCOMPARE(document.scene(), scene);
    }

    void clearTakesTheSolidsAndUndoBringsThemBack()
    {
        SceneDocument document;
        const Scene scene = sceneInSpace();
        document.reset(scene);

        document.clear();
        QVERIFY(document.scene().isEmpty());
        QVERIFY(document.scene().camera.has_value());

        document.undoStack()->undo();
        QCOMPARE(document.scene(), scene);
    }

    void theJointOfTwoPiecesMovesAsOne()
    {
        Scene scene;
        scene.method = "bezier-fill";
        Shape path;
        path.kind = PrimitiveKind::Bezier;
        path.fill = ShapeFill::EvenOdd;
        // The pieces meet at (4, 0), where the first one ends, and leave a gap at the other end.
        for (const LatticePoint &control :
             {latticePixel(0, 0), latticePixel(2, 4), latticePixel(4, 0), latticePixel(4, 0),
              latticePixel(8, 8), latticePixel(0, 9)})
            path.vertices.push_back({control, red});
        path.laterContours = {3};
        scene.shapes = {path};
        SceneDocument document;
        document.reset(scene);
        const Scene opened = document.scene();

        for (const int vertex : {2, 3}) {
            document.moveVertex({0, vertex}, latticePixel(5, vertex), document.newDrag());
            Shape expected = path;
            expected.vertices[2].position = expected.vertices[3].position = latticePixel(5, vertex);
            QCOMPARE(document.scene().shapes.front(), expected);
        }
        document.moveVertex({0, 5}, latticePixel(1, 9), document.newDrag());
        QCOMPARE(document.scene().shapes.front().vertices[0].position, latticePixel(0, 0));
        document.undoStack()->setIndex(0);
        QCOMPARE(document.scene(), opened);
    }
};

PIXELPLUMB_TEST(TestSceneDocument)

} // namespace tst_scenedocument

#include "tst_scenedocument.moc"
