// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>

namespace tst_undo {

using namespace pixelplumb;

namespace {

constexpr Colour yellow = {{255, 255, 0}};

/// A triangle shifted this many pixels to the right.
Triangle triangle(std::int64_t shift) { return triangleAt(shift, 0, shift + 4, 0, shift, 4); }

/// Three vertices, placed one by one.
void placeThree(SceneDocument &document)
{
    document.placeVertex(latticePixel(1, 2));
    document.placeVertex(latticePixel(9, 3));
    document.placeVertex(latticePixel(5, 8));
}

} // namespace

/// What can be undone in a document, in which steps, and when the document counts as modified.
class TestUndo : public QObject {
    Q_OBJECT

private slots:
    void undoOfTheThirdVertexGivesBackTwoPendingOnes()
    {
        SceneDocument document;
        placeThree(document);

        document.undoStack()->undo();

        const std::vector<Vertex> expected
            = {{latticePixel(1, 2), red}, {latticePixel(9, 3), green}};
        QCOMPARE(document.pendingVertices(), expected);
        QVERIFY(document.scene().triangles.empty());

        document.undoStack()->undo();
        document.undoStack()->undo();
        QVERIFY(document.pendingVertices().empty());
        for (int i = 0; i < 3; ++i)
            document.undoStack()->redo();
        QCOMPARE(document.scene().triangles.size(), 1U);
    }

    void undoOfAVertexGivesBackItsChosenColour()
    {
        SceneDocument document;
        document.setNextColour(yellow);
        document.placeVertex(latticePixel(1, 2));

        document.undoStack()->undo();

        QCOMPARE(document.nextColour(), yellow);
    }

    void everyChangeCanBeUndoneAndRedone_data()
    {
        using Change = std::function<void(SceneDocument &)>;
        QTest::addColumn<Change>("change");
        const auto row
            = [](const char *name, const Change &change) { QTest::newRow(name) << change; };
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
        row("clear", [](SceneDocument &d) { d.clear(); });
        row("frame", [](SceneDocument &d) { d.setFrame(frameOf(10, 12)); });
        row("settings", [](SceneDocument &d) {
            d.setSettings(ScanSettings{Arithmetic::Float32, {}, {}});
        });
    }
    void everyChangeCanBeUndoneAndRedone()
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

    void movesOfOneDragAreOneCommandAndOfTwoAreTwo()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        const int drag = document.newDrag();
        for (int x = 1; x <= 10; ++x)
            document.moveVertex({0, 0}, latticePixel(x, x), drag);

        QCOMPARE(document.undoStack()->count(), 2);
        document.moveVertex({0, 0}, latticePixel(2, 2), document.newDrag());
        document.undoStack()->undo();
        QCOMPARE(document.vertexAt({0, 0})->position, latticePixel(10, 10));
        document.undoStack()->undo();
        QCOMPARE(document.scene().triangles, std::vector{triangle(0)});
    }

    void drivesNoCommandWhenNothingChanges()
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

    void theSelectionGoesWithItsPrimitiveForwardsAndBack()
    {
        SceneDocument document;
        Scene scene;
        scene.triangles = {triangle(0), triangle(10), triangle(20), triangle(30)};
        document.reset(scene);
        document.selectVertex(VertexRef{1, 2});
        const auto selected = [&] { return document.selectedVertex().value_or(VertexRef{}); };

        document.movePrimitive(1, 2);
        QCOMPARE(selected(), (VertexRef{3, 2}));
        document.movePrimitive(0, 1);
        document.hidePrimitive(0);
        QCOMPARE(selected(), (VertexRef{2, 2}));
        document.moveVertex({2, 0}, latticePixel(50, 50), document.newDrag());
        document.showAllHidden();
        QCOMPARE(selected(), (VertexRef{3, 2}));
        while (document.undoStack()->canUndo())
            document.undoStack()->undo();
        QCOMPARE(selected(), (VertexRef{1, 2}));
        QCOMPARE(document.scene(), scene);
    }

    /// Each step keeps a scene.
    void aSceneOfManyPrimitivesCanBeUndoneInFewerSteps()
    {
        SceneDocument document;
        Scene scene;
        scene.triangles.assign(100'000, triangle(0));
        document.reset(scene);
        QCOMPARE(document.undoStack()->undoLimit(), 39);
        document.reset({});
        QVERIFY(document.undoStack()->undoLimit() > 1'000'000);
    }

    void resetForgetsHistoryAndIsUnmodified()
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

    void tellsWhenItBecomesModified()
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

    void waitingVerticesThatGoLeaveItClean()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        document.markSaved();
        document.placeVertex(latticePixel(1, 1));
        QVERIFY(document.isModified());
        document.undoStack()->undo();
        QVERIFY(!document.isModified());

        document.placeVertex(latticePixel(1, 1));
        document.discardPending();
        QVERIFY(!document.isModified());
        document.undoStack()->redo();
        QVERIFY(document.isModified());
        document.discardPending();
        document.moveVertex({0, 0}, latticePixel(2, 2), document.newDrag());
        QVERIFY(document.isModified());
        document.undoStack()->undo();
        QVERIFY(!document.isModified());
    }

    void aDragThatComesBackLeavesNoCommandAndNoChange()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        document.markSaved();
        document.selectVertex(VertexRef{0, 0});
        document.placeVertex(latticePixel(1, 1));
        document.discardPending();
        const int drag = document.newDrag();
        document.moveVertex({0, 0}, latticePixel(5, 5), drag);
        QVERIFY(document.isModified());
        document.moveVertex({0, 0}, latticePixel(0, 0), drag);

        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(document.scene().triangles, std::vector{triangle(0)});
        QVERIFY(!document.isModified());
    }

    void settingsThatAreChangedBackLeaveItClean()
    {
        SceneDocument document;
        Scene scene;
        scene.triangles = {triangle(0)};
        document.reset(scene);
        ScanSettings rounded = scene.settings;
        rounded.arithmetic = Arithmetic::Float32;

        document.setSettings(rounded);
        QVERIFY(document.isModified());
        document.setSettings(scene.settings);
        QVERIFY(!document.isModified());

        document.setSettings(rounded);
        document.setMethod("row-walk"); // only another view
        QVERIFY(document.isModified());
        document.setSettings(scene.settings);
        QVERIFY(!document.isModified());
        document.moveVertex({0, 0}, latticePixel(3, 3), document.newDrag());
        QVERIFY(document.isModified());
        document.moveVertex({0, 0}, scene.triangles[0].vertices[0].position, document.newDrag());
        QVERIFY(!document.isModified());
        document.markUnsaved();
        QVERIFY(document.isModified());
    }

    void discardedVerticesAreNotOnTheUndoStack()
    {
        SceneDocument document;
        document.addTriangle(triangle(0));
        document.placeVertex(latticePixel(1, 1));
        document.placeVertex(latticePixel(2, 1));
        document.moveVertex({VertexRef::pending, 1}, latticePixel(7, 7), document.newDrag());

        document.discardPending();

        QVERIFY(document.pendingVertices().empty());
        QCOMPARE(document.scene().triangles.size(), std::size_t(1));
        document.undoStack()->undo(); // undoes the triangle
        QVERIFY(document.pendingVertices().empty());
        QVERIFY(document.scene().triangles.empty());
    }

    void whatWasDoneSinceOutlivesDiscardedVertices()
    {
        SceneDocument document;
        document.placeVertex(latticePixel(1, 1));
        document.addTriangle(triangle(0));
        document.placeVertex(latticePixel(2, 1));

        document.discardPending();

        QVERIFY(document.pendingVertices().empty());
        QCOMPARE(document.scene().triangles.size(), std::size_t(1));
        document.undoStack()->undo();
        QCOMPARE(document.pendingVertices().size(), std::size_t(1));
    }
};

PIXELPLUMB_TEST(TestUndo)

} // namespace tst_undo

#include "tst_undo.moc"
