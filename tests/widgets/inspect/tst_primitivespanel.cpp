// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/appearance.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/playhead.h"
#include "widgets/model/primitivelistmodel.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

#include <algorithm>

namespace tst_primitivespanel {

using namespace pixelplumb;

namespace {

/// Two triangles, the second with its own z, and two lines.
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

/// The list of primitives in use: selected, moved, recoloured, deleted, edited.
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
        QCOMPARE(m_model->refAt(m_tree->currentIndex()), std::optional(VertexRef{0, 1}));
        QVERIFY(!document().isModified());
    }

    void coordinatesAreTypedInPlace()
    {
        const QModelIndex x
            = m_model->index(2, PrimitiveListModel::X, m_model->indexOfPrimitive(0));
        QCOMPARE(x.data().toString(), u"26"_s);
        m_tree->expand(m_model->indexOfPrimitive(0));
        m_tree->setCurrentIndex(x);
        type(x, "53/");
        QTest::keyClick(field(), Qt::Key_Return); // not a number: the field stays
        QVERIFY(field());
        QVERIFY(!document().isModified());
        QTest::keyClicks(field(), "2");
        QTest::keyClick(field(), Qt::Key_Return);

        QTRY_COMPARE(document().vertexAt({0, 2})->position, (LatticePoint{53 * 128, 44 * 256}));
        QCOMPARE(x.data().toString(), u"53/2"_s);
        QVERIFY(m_tree->isExpanded(m_model->indexOfPrimitive(0)));
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void aLongNumberIsReadToItsLastDigitWhereThereIsRoom()
    {
        auto *dock = named<QDockWidget>(*m_window, "primitivesDock");
        dock->setFloating(true);
        dock->resize(460, 400);
        const QModelIndex whole = m_model->indexOfPrimitive(0);
        m_tree->expand(whole);
        const QModelIndex x = m_model->index(1, PrimitiveListModel::X, whole);
        type(x, "61/3"); // 5205/256 is nearest
        QTest::keyClick(field(), Qt::Key_Return);
        QTRY_COMPARE(x.data().toString(), u"5205/256"_s);
        QTRY_VERIFY(m_tree->visualRect(x).width()
                    > m_tree->fontMetrics().horizontalAdvance(x.data().toString()));
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
        QCOMPARE(m_model->refAt(m_tree->currentIndex()), std::optional(VertexRef{0, 0}));
        QVERIFY(!button("primitivesUp")->isEnabled());
        press("primitivesDown");
        QCOMPARE(document().scene(), fourPrimitives());
        document().undoStack()->undo();
        document().undoStack()->undo();
        QVERIFY(!document().isModified());

        document().movePrimitive(2, 1);
        QCOMPARE(document().scene().shapes[0], fourPrimitives().shapes[1]);
        document().movePrimitive(2, 2); // there is no such position
        QCOMPARE(document().undoStack()->index(), 1);
    }

    void aPrimitiveTakesOneColourInOneStep()
    {
        const QModelIndex cell = m_model->index(0, PrimitiveListModel::ColourText);
        QCOMPARE(cell.data().toString(), u"several"_s);
        constexpr Colour amber{{255, 176, 0}};
        document().setPrimitiveColour(0, amber);
        QCOMPARE(cell.data().toString(), u"#ffb000"_s);
        for (const Vertex &vertex : document().verticesOf(0))
            QCOMPARE(vertex.colour, amber);
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void aPrimitiveIsHiddenByItsBoxAndShownAgain()
    {
        const QModelIndex row = m_model->indexOfPrimitive(0);
        QCOMPARE(row.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QVERIFY(m_model->setData(row, Qt::Checked, Qt::CheckStateRole)); // unchanged
        QVERIFY(!document().isModified());
        QVERIFY(m_model->setData(row, Qt::Unchecked, Qt::CheckStateRole));

        const Scene &scene = document().scene();
        QCOMPARE(scene.triangles.size(), std::size_t(1));
        QCOMPARE(scene.attributes[0].triangle, std::size_t(0)); // its z goes with it
        QCOMPARE(textsOf(PrimitiveListModel::Place), QStringList({"1", "2", "3", "4"}));
        QCOMPARE(textsOf(PrimitiveListModel::Name),
                 QStringList({"triangle, hidden", "triangle 0", "line 1", "line 2"}));
        QCOMPARE(named<QLabel>(*m_window, "primitivesSummary")->text(),
                 u"3 primitives, and 1 hidden that the numbers leave out"_s);
        QTRY_COMPARE(m_window->parts().playhead->traced()->trace->primitiveCount(), std::size_t(3));
        QVERIFY(document().isModified());

        QVERIFY(m_model->setData(m_model->index(0, 0), Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(document().scene(), fourPrimitives());
        document().undoStack()->undo();
        QCOMPARE(document().hiddenCount(), 1);
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
        QVERIFY(!document().isModified());
    }

    void theButtonHidesTheCurrentRowAndKeepsIt()
    {
        click(m_model->indexOfPrimitive(2));
        QCOMPARE(button("primitivesHide")->text(), u"Hide"_s);
        QVERIFY(button("primitivesHide")->toolTip().startsWith("Keep the primitive"));
        press("primitivesHide");
        QCOMPARE(document().scene().shapes.size(), std::size_t(1));
        QCOMPARE(m_tree->currentIndex().row(), 2);
        QVERIFY(!document().selectedVertex());
        QCOMPARE(button("primitivesHide")->text(), u"Show"_s);
        QVERIFY(button("primitivesHide")->toolTip().startsWith("Draw the primitive again"));
        QVERIFY(!button("primitivesColour")->isEnabled());
        press("primitivesHide");
        QCOMPARE(document().scene(), fourPrimitives());
        QCOMPARE(m_tree->currentIndex().row(), 2);

        press("primitivesHide");
        press("primitivesDelete"); // permanently
        QCOMPARE(document().hiddenCount(), 0);
        QCOMPARE(m_model->rowCount(), 3);
        document().undoStack()->undo();
        QCOMPARE(document().hiddenCount(), 1);
    }

    void aRightClickOffersWhatTheButtonsDo()
    {
        auto *menu = named<QMenu>(*m_window, "primitivesMenu");
        const QModelIndex row = m_model->indexOfPrimitive(1);
        rightClick(row);
        QVERIFY(menu->isVisible());
        QCOMPARE(m_model->refAt(m_tree->currentIndex()), std::optional(VertexRef{1, 0}));
        QStringList entries;
        for (const QAction *entry : menu->actions()) {
            entries += entry->text();
            QCOMPARE(button(qPrintable(entry->objectName()))->isEnabled(), entry->isEnabled());
        }
        QCOMPARE(entries, QStringList({"Earlier", "Later", "Colour…", "Form", "Hide", "Delete"}));

        choose(*menu, "primitivesUp");
        QCOMPARE(document().scene().triangles[0], fourPrimitives().triangles[1]);
        rightClick(m_tree->currentIndex());
        choose(*menu, "primitivesHide");
        QCOMPARE(document().hiddenCount(), 1);
        rightClick(m_tree->currentIndex());
        QCOMPARE(menu->actions()[4]->text(), u"Show"_s);
        choose(*menu, "primitivesDelete");
        QCOMPARE(document().scene().triangles.size(), std::size_t(1));
        QCOMPARE(document().hiddenCount(), 0);

        rightClick({});
        QVERIFY(!menu->isVisible()); // there is no row
    }

    void solidsAreHiddenAndShown()
    {
        document().reset(
            sceneOf({solidOf(SolidKind::Sphere), triangle3({-1, -1, 1}, {1, -1, 1}, {0, 1, 1})}));
        const QString told = named<QLabel>(*m_window, "primitivesSummary")->text();
        QVERIFY2(told.startsWith("0 primitives and 2 solids. The camera makes the triangles"),
                 qPrintable(told));
        QCOMPARE(textsOf(PrimitiveListModel::Name),
                 QStringList({"sphere, solid 0", "triangle3, solid 1"}));
        Playhead &playhead = *m_window->parts().playhead;
        QTRY_VERIFY(playhead.traced() && playhead.traced()->primitives.triangles.size() > 2);
        const std::size_t all = playhead.traced()->primitives.triangles.size();

        m_tree->setCurrentIndex(m_model->index(0, PrimitiveListModel::Name));
        press("primitivesHide");

        QCOMPARE(textsOf(PrimitiveListModel::Name),
                 QStringList({"sphere, hidden", "triangle3, solid 1"}));
        QTRY_COMPARE(playhead.traced()->primitives.triangles.size(), std::size_t(1));
        QCOMPARE(named<QAbstractButton>(*m_window, "primitivesHide")->text(), u"Show"_s);
        const auto reading = readScene(writeScene(document().scene()));
        QVERIFY(reading);
        QCOMPARE(reading->scene, document().scene());
        QVERIFY(m_model->setData(m_model->index(1, PrimitiveListModel::Name), Qt::Unchecked,
                                 Qt::CheckStateRole));
        QVERIFY(document().scene().isEmpty());
        document().showAllHidden();
        QTRY_COMPARE(playhead.traced()->primitives.triangles.size(), all);
        document().undoStack()->undo();
        document().undoStack()->undo();
        QTRY_COMPARE(playhead.traced()->primitives.triangles.size(), std::size_t(1));
    }

    void solidsAreMovedRecolouredAndDeleted()
    {
        const Scene scene
            = sceneOf({solidOf(SolidKind::Sphere), triangle3({-1, -1, 1}, {1, -1, 1}, {0, 1, 1})});
        document().reset(scene);
        const auto takeAmber = [this] {
            QTimer::singleShot(0, [] {
                auto *dialog = qobject_cast<QColorDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                dialog->setCurrentColor(QColor(255, 176, 0));
                dialog->accept();
            });
            press("primitivesColour");
        };
        m_tree->setCurrentIndex(m_model->index(0, PrimitiveListModel::Name));
        QVERIFY(!button("primitivesUp")->isEnabled());
        press("primitivesDown");
        QCOMPARE(document().scene().solids[1], scene.solids[0]);
        QCOMPARE(m_tree->currentIndex().row(), 1); // it stays selected
        QVERIFY(!button("primitivesDown")->isEnabled());

        takeAmber();
        QCOMPARE(document().scene().solids[1].colour, (Colour{{255, 176, 0}}));
        m_tree->setCurrentIndex(m_model->index(0, PrimitiveListModel::Name));
        takeAmber();
        for (const SolidCorner &corner : document().scene().solids[0].corners)
            QCOMPARE(corner.colour, (Colour{{255, 176, 0}}));
        const auto reading = readScene(writeScene(document().scene()));
        QVERIFY(reading);
        QCOMPARE(reading->scene, document().scene());

        press("primitivesDelete");
        QCOMPARE(textsOf(PrimitiveListModel::Name), QStringList({"sphere, solid 0"}));
        press("primitivesDelete");
        QVERIFY(document().scene().solids.empty());
        QVERIFY(!button("primitivesDelete")->isEnabled());
        while (document().undoStack()->canUndo())
            document().undoStack()->undo();
        QCOMPARE(document().scene(), scene);
        document().moveSolid(0, 2); // there is no such position
        document().deleteSolid(2); // nor such a solid
        QCOMPARE(document().undoStack()->index(), 0);
    }

    void hidingAndItsUndoKeepTheCurrentStep()
    {
        Playhead &playhead = *m_window->parts().playhead;
        playhead.seek(40);
        const auto column = playhead.currentColumnX();
        QVERIFY(column);
        document().hidePrimitive(3);
        QTRY_COMPARE(playhead.traced()->scene.hidden.size(), std::size_t(1));
        QCOMPARE(playhead.currentColumnX(), column);
        document().undoStack()->undo();
        QTRY_COMPARE(playhead.traced()->scene.hidden.size(), std::size_t(0));
        QCOMPARE(playhead.position(), std::size_t(40));
    }

    void whatIsAllHiddenIsSaid()
    {
        while (document().primitiveCount() > 0)
            document().hidePrimitive(0);
        QTRY_COMPARE(named<QLabel>(*m_window, "formulaSentence")->text(),
                     u"All primitives are hidden: Edit ▸ Show all hidden primitives."_s);
    }

    void theKeyHidesTheRowThatIsHighlighted()
    {
        DisplayOptions &options = *m_window->parts().options;
        options.setLayers({u"affine-map"_s});
        options.setAffineImage(
            AffineImage{0, {latticePixel(10, 40), latticePixel(30, 40), latticePixel(10, 20)}});
        click(m_model->indexOfPrimitive(1));
        clickPixel(*m_window, {30, 40}); // a corner of the map, which then takes the arrow keys
        QVERIFY(!document().selectedVertex());
        QVERIFY(!m_tree->selectionModel()->hasSelection());
        QVERIFY(!button("primitivesDelete")->isEnabled());
        QVERIFY(!action(*m_window, "hideSelected")->isEnabled());

        click(m_model->indexOfPrimitive(1)); // the same again
        QVERIFY(m_tree->selectionModel()->hasSelection());
        QTest::keyClick(m_tree, Qt::Key_H, Qt::ControlModifier);
        QCOMPARE(document().hiddenCount(), 1);
        QCOMPARE(document().scene().triangles[0], fourPrimitives().triangles[0]);
        QCOMPARE(m_tree->currentIndex().row(), 1);
    }

    void aVertexThatWaitsLeavesNoCurrentRow()
    {
        click(m_model->indexOfPrimitive(1));
        document().placeVertex(latticePixel(40, 20));
        document().selectVertex(VertexRef{VertexRef::pending, 0});
        QVERIFY(!m_tree->currentIndex().isValid());
        QVERIFY(!button("primitivesHide")->isEnabled());
    }

    void theKeyOfTheMenuDeletesInTheListToo()
    {
        click(m_model->indexOfPrimitive(2));
        QTest::keyClick(m_tree, Qt::Key_Delete);
        QCOMPARE(document().scene().shapes.size(), std::size_t(1));
        document().undoStack()->undo();
        QCOMPARE(document().scene(), fourPrimitives());
        QCOMPARE(m_model->rowCount(), 4);
        document().undoStack()->redo();
        press("primitivesHide"); // the next row, which became selected
        QCOMPARE(document().hiddenCount(), 1);
        QTest::keyClick(m_tree, Qt::Key_Delete);
        QCOMPARE(document().hiddenCount(), 0);
        QCOMPARE(m_model->rowCount(), 2);

        click(m_model->indexOfPrimitive(0));
        QTest::keyClick(m_tree, Qt::Key_Delete);
        QCOMPARE(m_model->rowCount(), 1);
    }

    void whereACoordinateIsTypedTheKeyDeletesFigures()
    {
        const QModelIndex whole = m_model->indexOfPrimitive(0);
        m_tree->expand(whole);
        const QModelIndex x = m_model->index(2, PrimitiveListModel::X, whole);
        m_tree->setCurrentIndex(x);
        m_tree->edit(x);
        QVERIFY(field());
        field()->selectAll();
        QTest::keyClick(field(), Qt::Key_Delete);
        QCOMPARE(field()->text(), QString());
        QCOMPARE(document().scene(), fourPrimitives());
    }

    void theBoxOfAHiddenOneIsSeen_data() { addPalettes(); }
    void theBoxOfAHiddenOneIsSeen()
    {
        QFETCH(QPalette, palette);
        QApplication::setPalette(palette);
        QTRY_COMPARE(m_tree->palette().color(QPalette::Base), palette.color(QPalette::Base));
        document().hidePrimitive(1);
        m_tree->setCurrentIndex({});
        grabbed(*m_window, "primitives");
        const QRect row = m_tree->visualRect(m_model->index(1, PrimitiveListModel::Name));
        const QImage shown = m_tree->viewport()->grab(row).toImage();
        const QColor base = palette.color(QPalette::Base);
        double most = 0; // the contrast of the box before the name
        for (int x = 0; x < shown.height(); ++x)
            most = std::max(most, contrastRatio(shown.pixelColor(x, shown.height() / 2), base));
        QVERIFY2(most >= 3, qPrintable(QString::number(most)));
    }

    void theMenuHidesTheSelectedOneAndShowsAll()
    {
        QVERIFY(!action(*m_window, "showAllHidden")->isEnabled());
        QVERIFY(!action(*m_window, "hideSelected")->isEnabled());
        for (const int primitive : {1, 2, 0}) {
            document().selectVertex(VertexRef{primitive, 0});
            action(*m_window, "hideSelected")->trigger();
        }
        QCOMPARE(document().primitiveCount(), 1);
        action(*m_window, "showAllHidden")->trigger();
        QCOMPARE(document().scene(), fourPrimitives());
        document().undoStack()->undo();
        QCOMPARE(document().hiddenCount(), 3);
        document().clear();
        QCOMPARE(m_model->rowCount(), 0);
    }

    void hiddenOnesKeepTheirPlacesWhateverIsDone_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 40; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    /// Compared with a list of colours that identify the primitives, in the file's order.
    void hiddenOnesKeepTheirPlacesWhateverIsDone()
    {
        QFETCH(quint32, seed);
        QRandomGenerator random(seed);
        struct Known {
            std::uint8_t red;
            bool isTriangle;
            bool isHidden;
        };
        std::vector<Known> known;
        Scene scene;
        for (std::uint8_t i = 0; i < 8; ++i) {
            const bool isTriangle = i < 4;
            known.push_back({i, isTriangle, false});
            const Vertex vertex{latticePixel(i, i), {{i, 0, 0}}};
            if (isTriangle)
                scene.triangles.push_back({{vertex, vertex, vertex}});
            else
                scene.shapes.emplace_back().vertices = {vertex, vertex};
        }
        scene.attributes = {{2, {}, noMaterial}};
        scene.attributes[0].vertices[0].z = attributeOne;
        SceneDocument edited;
        edited.reset(scene);
        const auto nth = [&known](int index, bool isHidden) {
            return std::ranges::find_if(known, [&, seen = 0](const Known &each) mutable {
                return each.isHidden == isHidden && seen++ == index;
            });
        };
        for (int step = 0; step < 30; ++step) {
            const int drawn = edited.primitiveCount();
            const int hidden = edited.hiddenCount();
            const bool takesHidden = hidden > 0 && random.bounded(2) == 0;
            if (!takesHidden && drawn == 0)
                continue;
            const int index = int(random.bounded(takesHidden ? hidden : drawn));
            const auto place = nth(index, takesHidden);
            if (random.bounded(8) == 0) {
                takesHidden ? edited.deleteHidden(index) : edited.deletePrimitive(index);
                known.erase(place);
            } else {
                takesHidden ? edited.showHidden(index) : edited.hidePrimitive(index);
                place->isHidden = !takesHidden;
            }
            if (random.bounded(4) == 0) {
                edited.undoStack()->undo();
                edited.undoStack()->redo();
            }
            const QList<QByteArray> lines = writeScene(edited.scene()).split('\n');
            std::size_t at = 0;
            for (const QByteArray &line : lines) {
                if (!line.startsWith("        { "))
                    continue;
                QVERIFY(at < known.size());
                const Known &expected = known[at++];
                const QByteArray colour = "\"#0" + QByteArray::number(int(expected.red)) + "0000\"";
                QVERIFY2(line.contains(colour), line.constData());
                QCOMPARE(line.contains("\"hidden\": true"), expected.isHidden);
                QCOMPARE(line.contains("\"z\""), expected.red == 2);
            }
            QCOMPARE(at, known.size());
        }
        edited.showAllHidden();
        QCOMPARE(edited.hiddenCount(), 0);
        QCOMPARE(std::size_t(edited.primitiveCount()), known.size());
        while (edited.undoStack()->canUndo())
            edited.undoStack()->undo();
        QCOMPARE(edited.scene(), scene);
    }

    void theModelKeepsQtsRules()
    {
        const QAbstractItemModelTester tester(
            m_model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        document().moveVertex({0, 0}, latticePixel(7, 7), document().newDrag());
        document().addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        document().hidePrimitive(1);
        document().showHidden(0);
        document().clear();
        QCOMPARE(m_model->rowCount(), 0);
        document().undoStack()->undo();
        QCOMPARE(m_model->rowCount(), 5);
    }

private:
    QStringList textsOf(PrimitiveListModel::Column column) const
    {
        QStringList texts;
        for (int row = 0; row < m_model->rowCount(); ++row)
            texts += m_model->index(row, column).data().toString();
        return texts;
    }

    SceneDocument &document() { return *m_window->parts().document; }
    QAbstractButton *button(const char *name) { return named<QAbstractButton>(*m_window, name); }
    void press(const char *name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    void click(const QModelIndex &index)
    {
        QTest::mouseClick(m_tree->viewport(), Qt::LeftButton, {},
                          m_tree->visualRect(index).center());
    }
    void rightClick(const QModelIndex &index)
    {
        const QPoint place = index.isValid()
            ? m_tree->visualRect(index).center()
            : m_tree->viewport()->rect().bottomRight() - QPoint(4, 4);
        QTest::mouseClick(m_tree->viewport(), Qt::RightButton, {}, place);
        QContextMenuEvent asked(QContextMenuEvent::Mouse, place,
                                m_tree->viewport()->mapToGlobal(place));
        QApplication::sendEvent(m_tree->viewport(), &asked);
    }
    static void choose(QMenu &menu, const char *name)
    {
        QTest::mouseClick(&menu, Qt::LeftButton, {},
                          menu.actionGeometry(named<QAction>(menu, name)).center());
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

PIXELPLUMB_TEST(TestPrimitivesPanel)

} // namespace tst_primitivespanel

#include "tst_primitivespanel.moc"
