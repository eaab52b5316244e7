// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/scanning.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/playhead.h"
#include "widgets/model/primitivelistmodel.h"
#include "widgets/model/scenedocument.h"

#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QTest>
#include <QTreeView>

using namespace pixelplumb;

namespace {

/// Two triangles, the second with a z of its own, and two lines.
Scene fourPrimitives()
{
    Scene scene;
    scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44), triangleAt(2, 30, 20, 44, 6, 46)};
    scene.attributes = {{1, {}, noMaterial}};
    scene.attributes[0].vertices[0].z = attributeOne / 4;
    scene.shapes.resize(2);
    for (std::int64_t i = 0; i < 2; ++i) {
        Shape &line = scene.shapes[std::size_t(i)];
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(1, 1 + i), red}, {latticePixel(30, 1 + i), green}};
    }
    return scene;
}

} // namespace

/// The list of primitives, by hand: chosen, moved, recoloured, deleted, typed.
class TestPrimitivesPanel : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow(fourPrimitives());
        action(*m_window, "primitivesDockToggle")->trigger();
        m_tree = named<QTreeView>(*m_window, "primitivesTree");
        m_model = qobject_cast<PrimitiveListModel *>(m_tree->model());
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(m_tree->isVisible());
    }
    void cleanup() { m_window.reset(); }

    void aChosenRowIsChosenOnTheCanvasAndTheOtherWayRound()
    {
        click(m_model->indexOfPrimitive(1));
        QCOMPARE(document().selectedVertex(), std::optional(VertexRef{1, 0}));
        QVERIFY(m_window->parts().canvas->spokenState().startsWith("vertex 0 of triangle 1"));

        clickPixel(*m_window, {58, 12}); // a handle
        QCOMPARE(m_model->refAt(m_tree->currentIndex()), (VertexRef{0, 1}));
        QVERIFY(!document().isModified());
    }

    void coordinatesAreTypedInPlace()
    {
        const QModelIndex x
            = m_model->index(2, PrimitiveListModel::X, m_model->indexOfPrimitive(0));
        QCOMPARE(x.data().toString(), QStringLiteral("26"));
        m_tree->expand(m_model->indexOfPrimitive(0));
        m_tree->setCurrentIndex(x);
        type(x, "53/");
        QTest::keyClick(field(), Qt::Key_Return); // is no number: the field stays
        QVERIFY(field());
        QVERIFY(!document().isModified());
        QTest::keyClicks(field(), "2");
        QTest::keyClick(field(), Qt::Key_Return);

        QTRY_COMPARE(document().vertexAt({0, 2})->position, (LatticePoint{53 * 128, 44 * 256}));
        QCOMPARE(x.data().toString(), QStringLiteral("53/2"));
        QVERIFY(m_tree->isExpanded(m_model->indexOfPrimitive(0)));
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void primitivesChangePlacesInTheDrawingOrder()
    {
        click(m_model->indexOfPrimitive(1));
        QVERIFY(!button("primitivesDown")->isEnabled()); // triangles come before shapes
        press("primitivesUp");

        const Scene &scene = document().scene();
        QCOMPARE(scene.triangles[0], fourPrimitives().triangles[1]);
        QCOMPARE(scene.triangles[1], fourPrimitives().triangles[0]);
        QCOMPARE(scene.attributes.size(), std::size_t(1));
        QCOMPARE(scene.attributes[0].triangle, std::size_t(0)); // its z goes with it
        QCOMPARE(m_model->refAt(m_tree->currentIndex()), (VertexRef{0, 0}));
        QVERIFY(!button("primitivesUp")->isEnabled());
        press("primitivesDown");
        QCOMPARE(document().scene(), fourPrimitives());
        document().undoStack()->undo();
        document().undoStack()->undo();
        QVERIFY(!document().isModified());

        document().movePrimitive(2, 1);
        QCOMPARE(document().scene().shapes[0], fourPrimitives().shapes[1]);
        document().movePrimitive(2, 2); // there is no such place
        QCOMPARE(document().undoStack()->index(), 1);
    }

    void aPrimitiveTakesOneColourInOneStep()
    {
        const QModelIndex cell = m_model->index(0, PrimitiveListModel::ColourText);
        QCOMPARE(cell.data().toString(), QStringLiteral("several"));
        constexpr Colour amber{{255, 176, 0}};
        document().setPrimitiveColour(0, amber);
        QCOMPARE(cell.data().toString(), QStringLiteral("#ffb000"));
        for (const Vertex &vertex : document().verticesOf(0))
            QCOMPARE(vertex.colour, amber);
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void deletingOneCanBeUndone()
    {
        click(m_model->indexOfPrimitive(2));
        press("primitivesDelete");
        QCOMPARE(document().scene().shapes.size(), std::size_t(1));
        QCOMPARE(m_model->rowCount(), 3);
        document().undoStack()->undo();
        QCOMPARE(m_model->rowCount(), 4);
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void theModelKeepsQtsRules()
    {
        const QAbstractItemModelTester tester(
            m_model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        document().moveVertex({0, 0}, latticePixel(7, 7), document().newDrag());
        document().addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        document().clear();
        QCOMPARE(m_model->rowCount(), 0);
        document().undoStack()->undo();
        QCOMPARE(m_model->rowCount(), 5);
    }

private:
    SceneDocument &document() { return *m_window->parts().document; }
    QAbstractButton *button(const char *name) { return named<QAbstractButton>(*m_window, name); }
    void press(const char *name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    void click(const QModelIndex &index)
    {
        QTest::mouseClick(m_tree->viewport(), Qt::LeftButton, {},
                          m_tree->visualRect(index).center());
    }
    QLineEdit *field() { return named<QLineEdit>(*m_tree, "coordinateField"); }
    void type(const QModelIndex &index, const char *text)
    {
        m_tree->edit(index);
        QVERIFY(field());
        field()->selectAll();
        QTest::keyClicks(field(), text);
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    QTreeView *m_tree = nullptr;
    PrimitiveListModel *m_model = nullptr;
};

QTEST_MAIN(TestPrimitivesPanel)
#include "tst_primitivespanel.moc"
