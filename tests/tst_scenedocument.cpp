// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenedocument.h"

#include <QSignalSpy>
#include <QTest>

using namespace pixelplumb;

namespace {

constexpr Colour red{{255, 0, 0}};
constexpr Colour green{{0, 255, 0}};
constexpr Colour blue{{0, 0, 255}};
constexpr Colour yellow{{255, 255, 0}};

Triangle triangle(std::int64_t shift)
{
    return {{{{latticePixel(shift, 0), red},
              {latticePixel(shift + 4, 0), green},
              {latticePixel(shift, 4), blue}}}};
}

FrameSpec frameOf(int width, int height)
{
    FrameSpec frame;
    frame.width = width;
    frame.height = height;
    return frame;
}

void placeThree(SceneDocument &document)
{
    document.placeVertex(latticePixel(1, 2));
    document.placeVertex(latticePixel(9, 3));
    document.placeVertex(latticePixel(5, 8));
}

} // namespace

class SceneDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void everyThirdVertexCompletesATriangle();
    void defaultColoursAreRedGreenAndBlue();
    void aChosenColourIsForTheNextVertexAlone();
    void undoOfTheThirdVertexGivesBackTwoPendingOnes();
    void undoOfAVertexGivesBackItsChosenColour();
    void everyChangeCanBeUndoneAndRedone_data();
    void everyChangeCanBeUndoneAndRedone();
    void movesOfOneDragAreOneCommand();
    void movesOfTwoDragsAreTwoCommands();
    void aDragThatComesBackLeavesNoCommand();
    void drivesNoCommandWhenNothingChanges();
    void refusesPositionsBeyondTheRange_data();
    void refusesPositionsBeyondTheRange();
    void refusesFramesThatCannotBeMade_data();
    void refusesFramesThatCannotBeMade();
    void refusesAMethodThatDoesNotExist();
    void selectionFollowsItsVertex();
    void selectionGoesWithItsTriangle();
    void snapsToTheChosenLattice_data();
    void snapsToTheChosenLattice();
    void resetForgetsHistoryAndIsUnmodified();
    void tellsWhenItBecomesModified();
};

void SceneDocumentTest::everyThirdVertexCompletesATriangle()
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

void SceneDocumentTest::defaultColoursAreRedGreenAndBlue()
{
    SceneDocument document;
    for (int round = 0; round < 2; ++round) {
        for (const Colour &expected : {red, green, blue}) {
            QCOMPARE(document.nextColour(), expected);
            document.placeVertex(latticePixel(round, round));
        }
    }
}

void SceneDocumentTest::aChosenColourIsForTheNextVertexAlone()
{
    SceneDocument document;
    document.placeVertex(latticePixel(1, 2));
    document.setNextColour(yellow);
    document.placeVertex(latticePixel(9, 3));

    QCOMPARE(document.pendingVertices()[1].colour, yellow);
    QCOMPARE(document.nextColour(), blue);
}

void SceneDocumentTest::undoOfTheThirdVertexGivesBackTwoPendingOnes()
{
    SceneDocument document;
    placeThree(document);

    document.undoStack()->undo();

    const std::vector<Vertex> expected = {{latticePixel(1, 2), red}, {latticePixel(9, 3), green}};
    QCOMPARE(document.pendingVertices(), expected);
    QVERIFY(document.scene().triangles.empty());

    document.undoStack()->undo();
    document.undoStack()->undo();
    QVERIFY(document.pendingVertices().empty());
    for (int i = 0; i < 3; ++i)
        document.undoStack()->redo();
    QCOMPARE(document.scene().triangles.size(), 1U);
}

void SceneDocumentTest::undoOfAVertexGivesBackItsChosenColour()
{
    SceneDocument document;
    document.setNextColour(yellow);
    document.placeVertex(latticePixel(1, 2));

    document.undoStack()->undo();

    QCOMPARE(document.nextColour(), yellow);
}

void SceneDocumentTest::everyChangeCanBeUndoneAndRedone_data()
{
    using Change = std::function<void(SceneDocument &)>;
    QTest::addColumn<Change>("change");
    const auto row = [](const char *name, const Change &change) { QTest::newRow(name) << change; };
    row("place", [](SceneDocument &d) { d.placeVertex(latticePixel(7, 7)); });
    row("move", [](SceneDocument &d) { d.moveVertex({1, 2}, latticePixel(7, 7), 1); });
    row("move a pending vertex", [](SceneDocument &d) {
        d.moveVertex({VertexRef::pending, 0}, latticePixel(7, 7), 1);
    });
    row("colour", [](SceneDocument &d) { d.setVertexColour({0, 1}, yellow); });
    row("colour of a pending vertex", [](SceneDocument &d) {
        d.setVertexColour({VertexRef::pending, 0}, yellow);
    });
    row("add triangle", [](SceneDocument &d) { d.addTriangle(triangle(20)); });
    row("delete first triangle", [](SceneDocument &d) { d.deletePrimitive(0); });
    row("delete the triangle of a vertex", [](SceneDocument &d) { d.deleteVertex({1, 1}); });
    row("delete a pending vertex", [](SceneDocument &d) {
        d.deleteVertex({VertexRef::pending, 0});
    });
    row("discard pending", [](SceneDocument &d) { d.discardPending(); });
    row("clear", [](SceneDocument &d) { d.clear(); });
    row("frame", [](SceneDocument &d) { d.setFrame(frameOf(10, 12)); });
    row("settings", [](SceneDocument &d) {
        d.setSettings(ScanSettings{Arithmetic::Float32, {}, {}});
    });
}

void SceneDocumentTest::everyChangeCanBeUndoneAndRedone()
{
    QFETCH(std::function<void(SceneDocument &)>, change);
    SceneDocument document;
    Scene scene;
    scene.triangles = {triangle(0), triangle(10)};
    document.reset(scene);
    document.placeVertex(latticePixel(3, 3));
    const std::vector<Vertex> pending = document.pendingVertices();

    change(document);
    const Scene changed = document.scene();
    const std::vector<Vertex> changedPending = document.pendingVertices();
    QVERIFY(changed != scene || changedPending != pending);
    QCOMPARE(document.undoStack()->count(), 2);

    document.undoStack()->undo();
    QCOMPARE(document.scene(), scene);
    QCOMPARE(document.pendingVertices(), pending);

    document.undoStack()->redo();
    QCOMPARE(document.scene(), changed);
    QCOMPARE(document.pendingVertices(), changedPending);
}

void SceneDocumentTest::movesOfOneDragAreOneCommand()
{
    SceneDocument document;
    document.addTriangle(triangle(0));
    const int drag = document.newDrag();
    for (int x = 1; x <= 10; ++x)
        document.moveVertex({0, 0}, latticePixel(x, x), drag);

    QCOMPARE(document.undoStack()->count(), 2);
    QCOMPARE(document.vertexAt({0, 0})->position, latticePixel(10, 10));
    document.undoStack()->undo();
    QCOMPARE(document.scene().triangles, std::vector{triangle(0)});
}

void SceneDocumentTest::movesOfTwoDragsAreTwoCommands()
{
    SceneDocument document;
    document.addTriangle(triangle(0));
    document.moveVertex({0, 0}, latticePixel(1, 1), document.newDrag());
    document.moveVertex({0, 0}, latticePixel(2, 2), document.newDrag());

    document.undoStack()->undo();

    QCOMPARE(document.vertexAt({0, 0})->position, latticePixel(1, 1));
}

void SceneDocumentTest::aDragThatComesBackLeavesNoCommand()
{
    SceneDocument document;
    document.addTriangle(triangle(0));
    const int drag = document.newDrag();
    document.moveVertex({0, 0}, latticePixel(5, 5), drag);
    document.moveVertex({0, 0}, latticePixel(0, 0), drag);

    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.scene().triangles, std::vector{triangle(0)});
}

void SceneDocumentTest::drivesNoCommandWhenNothingChanges()
{
    SceneDocument document;
    document.addTriangle(triangle(0));
    document.markSaved();

    document.moveVertex({0, 0}, latticePixel(0, 0), document.newDrag());
    document.setVertexColour({0, 0}, red);
    document.setFrame(document.scene().frame);
    document.setSettings(document.scene().settings);
    document.setMethod(document.scene().method);
    document.deletePrimitive(7);
    document.deleteVertex({VertexRef::pending, 0});
    document.discardPending();

    QVERIFY(!document.isModified());
}

void SceneDocumentTest::refusesPositionsBeyondTheRange_data()
{
    QTest::addColumn<Lattice>("x");
    QTest::addColumn<bool>("accepted");
    QTest::newRow("2^30 px") << largestCoordinate << true;
    QTest::newRow("2^30 px and 1/256") << largestCoordinate + 1 << false;
    QTest::newRow("-2^30 px") << -largestCoordinate << true;
    QTest::newRow("-2^30 px and 1/256 less") << -largestCoordinate - 1 << false;
}

void SceneDocumentTest::refusesPositionsBeyondTheRange()
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

void SceneDocumentTest::refusesFramesThatCannotBeMade_data()
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

void SceneDocumentTest::refusesFramesThatCannotBeMade()
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

void SceneDocumentTest::refusesAMethodThatDoesNotExist()
{
    SceneDocument document;
    QSignalSpy refused(&document, &SceneDocument::refused);

    document.setMethod("no-such-method");

    QCOMPARE(document.scene().method, std::string("column-scan"));
    QVERIFY(refused.at(0).at(0).toString().contains("no-such-method"));
}

void SceneDocumentTest::selectionFollowsItsVertex()
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

void SceneDocumentTest::selectionGoesWithItsTriangle()
{
    SceneDocument document;
    document.addTriangle(triangle(0));
    document.selectVertex(VertexRef{0, 1});
    QSignalSpy selectionChanged(&document, &SceneDocument::selectionChanged);

    document.deleteVertex({0, 1});

    QVERIFY(!document.selectedVertex());
    QCOMPARE(selectionChanged.count(), 1);
}

void SceneDocumentTest::snapsToTheChosenLattice_data()
{
    QTest::addColumn<Snap>("snap");
    QTest::addColumn<Lattice>("x");
    QTest::addColumn<Lattice>("expected");
    // In units of 1/256 px; a sixteenth has 16 of them.
    QTest::newRow("pixel, down") << Snap::Pixel << Lattice(256 + 127) << Lattice(256);
    QTest::newRow("pixel, the middle goes up") << Snap::Pixel << Lattice(256 + 128) << Lattice(512);
    QTest::newRow("pixel, negative") << Snap::Pixel << Lattice(-129) << Lattice(-256);
    QTest::newRow("sixteenth") << Snap::Sixteenth << Lattice(25) << Lattice(32);
    QTest::newRow("the lattice itself") << Snap::Finest << Lattice(25) << Lattice(25);
}

void SceneDocumentTest::snapsToTheChosenLattice()
{
    QFETCH(Snap, snap);
    QFETCH(Lattice, x);
    QFETCH(Lattice, expected);
    SceneDocument document;
    document.setSnap(snap);

    QCOMPARE(document.snapped({x, -x}).x, expected);
}

void SceneDocumentTest::resetForgetsHistoryAndIsUnmodified()
{
    SceneDocument document;
    placeThree(document);
    document.placeVertex(latticePixel(0, 0));
    document.selectVertex(VertexRef{0, 1});
    Scene scene;
    scene.triangles = {triangle(3)};

    document.reset(scene);

    QCOMPARE(document.scene(), scene);
    QVERIFY(document.pendingVertices().empty());
    QVERIFY(!document.isModified());
    QVERIFY(!document.undoStack()->canUndo());
    QVERIFY(!document.selectedVertex());
}

void SceneDocumentTest::tellsWhenItBecomesModified()
{
    SceneDocument document;
    QSignalSpy modifiedChanged(&document, &SceneDocument::modifiedChanged);

    document.placeVertex(latticePixel(1, 1));
    QCOMPARE(modifiedChanged.takeLast(), QVariantList{true});
    document.markSaved();
    QCOMPARE(modifiedChanged.takeLast(), QVariantList{false});
    document.undoStack()->undo();
    QCOMPARE(modifiedChanged.takeLast(), QVariantList{true});
}

QTEST_GUILESS_MAIN(SceneDocumentTest)
#include "tst_scenedocument.moc"
