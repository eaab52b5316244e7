// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/primitivespanel.h"
#include "widgets/look/colourbutton.h"
#include "widgets/model/primitivelistmodel.h"

#include <QtTest>
#include <QtWidgets>

#include <algorithm>

namespace tst_primitivestree {

using namespace pixelplumb;

namespace {

/// All shipped scenes, and an empty one.
std::vector<Scene> shippedScenes()
{
    std::vector<Scene> scenes(1);
    const QDir folder = QFileInfo(defaultScene()).dir();
    for (const QFileInfo &file : folder.entryInfoList({u"*.json"_s})) {
        QFile opened(file.filePath());
        if (opened.open(QIODevice::ReadOnly)) {
            if (const auto reading = readScene(opened.readAll()))
                scenes.push_back(reading->scene);
        }
    }
    return scenes;
}

Scene fourPrimitives()
{
    Scene scene;
    scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44), triangleAt(2, 30, 20, 44, 6, 46)};
    scene.shapes.resize(2);
    for (Shape &line : scene.shapes) {
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(1, 1), red}, {latticePixel(30, 1), green}};
    }
    return scene;
}

/// Where a widget was painted.
class PaintedRegion : public QObject {
public:
    explicit PaintedRegion(QWidget *widget) { widget->installEventFilter(this); }
    QRegion region;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            region += static_cast<QPaintEvent *>(event)->region();
        return QObject::eventFilter(watched, event);
    }
};

} // namespace

/// The list of primitives follows every scene; keys and mouse edit its contents.
class TestPrimitivesTree : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        action(*m_window, "primitivesDockToggle")->trigger();
        m_tree = named<QTreeView>(*m_window, "primitivesTree");
        m_model = qobject_cast<PrimitiveListModel *>(m_tree->model());
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_tree->expand(m_model->indexOfPrimitive(0));
    }
    void cleanup() { m_window.reset(); }

    void everySceneFollowsSolidsTrianglesAndNothing()
    {
        const std::vector<Scene> scenes = shippedScenes();
        QVERIFY(scenes.size() > 20);
        SceneDocument document;
        PrimitivesPanel panel(&document);
        panel.show();
        const auto *tree = named<QTreeView>(panel, "primitivesTree");
        const auto follow = [&](const Scene &scene) {
            document.reset(scene);
            const std::size_t all = scene.triangles.size() + scene.solids.size()
                + scene.shapes.size() + scene.hidden.size();
            QCOMPARE(std::size_t(tree->model()->rowCount()), all);
        };
        for (const Scene &scene : scenes) { // every scene also after the previous one
            follow(scene);
            follow(Scene());
            follow(scene);
            follow(fourPrimitives());
            follow(scene);
        }
    }

    void aVertexThatIsMovedElsewhereIsPaintedAnew()
    {
        QCoreApplication::processEvents();
        PaintedRegion painted(m_tree->viewport());
        const QRect cell = m_tree->visualRect(cellOf(1, PrimitiveListModel::X));
        QVERIFY(m_tree->viewport()->rect().contains(cell));

        document().moveVertex({0, 1}, latticePixel(48, 12), document().newDrag());

        QCOMPARE(cellOf(1, PrimitiveListModel::X).data().toString(), u"48"_s);
        QTRY_VERIFY((QRegion(cell) - painted.region).isEmpty());
    }

    void numbersAreEditedByKeysAlone_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("F2") << int(Qt::Key_F2);
        QTest::newRow("Enter") << int(Qt::Key_Return);
    }
    void numbersAreEditedByKeysAlone()
    {
        QFETCH(int, key);
        m_tree->setFocus();
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(0));
        QTest::keyClick(m_tree, Qt::Key_Down);
        QTest::keyClick(m_tree, Qt::Key_Down); // vertex 1
        QTest::keyClick(m_tree, Qt::Key(key));
        typeOver("50");
        QTest::keyClick(field(), Qt::Key_Tab); // moves on to y
        typeOver("21/2");
        QTest::keyClick(field(), Qt::Key_Tab); // moves on to the next vertex
        typeOver("30");
        QTest::keyClick(field(), Qt::Key_Return);

        QTRY_COMPARE(document().vertexAt({0, 1})->position,
                     (LatticePoint{50 * unitsPerPixel, 21 * unitsPerPixel / 2}));
        QTRY_COMPARE(document().vertexAt({0, 2})->position.x, Lattice(30 * unitsPerPixel));
    }

    void aColourIsTypedInItsCell()
    {
        m_tree->setFocus();
        m_tree->setCurrentIndex(cellOf(1, PrimitiveListModel::ColourText));
        const Colour before = document().vertexAt({0, 1})->colour;
        QTest::keyClick(m_tree, Qt::Key_F2);
        auto *cell = named<QLineEdit>(*m_tree, "colourField");
        QSignalSpy refused(&document(), &SceneDocument::refused);
        cell->setText(u"#ffb0"_s);
        QTest::keyClick(cell, Qt::Key_Return);
        QCOMPARE(refused.size(), 1);
        QVERIFY(refused[0][0].toString().contains(u"#rrggbb"_s));
        QCOMPARE(document().vertexAt({0, 1})->colour, before);

        cell->setText(u"#ffb000"_s);
        QTest::keyClick(cell, Qt::Key_Return);
        QTRY_COMPARE(document().vertexAt({0, 1})->colour, (Colour{{255, 176, 0}}));
        document().undoStack()->undo();
        QCOMPARE(document().vertexAt({0, 1})->colour, before);
        QVERIFY(!opaqueColour(u"#ffb00080"_s));
    }

    void aDoubleClickOnAColourAsksForAnother()
    {
        const QPoint place = m_tree->visualRect(cellOf(2, PrimitiveListModel::ColourText)).center();
        takeAmber();
        QTest::mouseClick(m_tree->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(m_tree->viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(document().vertexAt({0, 2})->colour, (Colour{{255, 176, 0}}));
        QVERIFY(document().vertexAt({0, 1})->colour != (Colour{{255, 176, 0}}));

        takeAmber();
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(0));
        QTest::keyClick(m_tree, Qt::Key_Return);
        QCOMPARE(document().vertexAt({0, 1})->colour, (Colour{{255, 176, 0}}));
    }

    void aCircleTakesTheFormOfAnEllipseAndIsFilled()
    {
        Scene scene;
        scene.method = "circle-midpoint";
        scene.shapes.resize(1);
        scene.shapes[0].kind = PrimitiveKind::Circle;
        scene.shapes[0].fill = ShapeFill::Outline;
        scene.shapes[0].vertices = {{latticePixel(20, 20), red}, {latticePixel(29, 29), red}};
        document().reset(scene);
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(0));
        QCOMPARE(checkedForms(), QStringList({"Circle", "Outlined"}));
        takeForm("Circle"); // it already has this form
        QCOMPARE(checkedForms(), QStringList({"Circle", "Outlined"}));
        QVERIFY(!document().undoStack()->canUndo());

        takeForm("Ellipse: its corner is free");
        QCOMPARE(document().shapeAt(0).kind, PrimitiveKind::Ellipse);
        document().moveVertex({0, 1}, latticePixel(32, 24), document().newDrag());
        QCOMPARE(document().shapeAt(0).vertices[1].position, latticePixel(32, 24));
        takeForm("Filled");
        QCOMPARE(document().shapeAt(0).fill, ShapeFill::NonZero);
        QCOMPARE(checkedForms(), QStringList({"Ellipse: its corner is free", "Filled"}));
        takeForm("Circle"); // and its corner moves onto its square
        QCOMPARE(document().shapeAt(0).vertices[1].position, latticePixel(32, 32));

        for (int edits = 0; edits < 4; ++edits)
            document().undoStack()->undo();
        QCOMPARE(document().scene(), scene);
    }

    void aCircleGetsSmallerByEitherCoordinateOfItsCorner()
    {
        Scene scene;
        scene.method = "circle-midpoint";
        scene.shapes.resize(1);
        scene.shapes[0].kind = PrimitiveKind::Circle;
        scene.shapes[0].vertices = {{latticePixel(20, 20), red}, {latticePixel(40, 40), red}};
        document().reset(scene);
        const auto corner = [this] { return document().vertexAt({0, 1})->position; };
        const auto type = [this](PrimitiveListModel::Column column, const char *text) {
            QVERIFY(m_model->setData(cellOf(1, column), QLatin1String(text), Qt::EditRole));
        };
        type(PrimitiveListModel::X, "35");
        QCOMPARE(corner(), latticePixel(35, 35));
        type(PrimitiveListModel::Y, "29");
        QCOMPARE(corner(), latticePixel(29, 29));
        const int edits = document().undoStack()->count();
        type(PrimitiveListModel::Y, "29");
        QCOMPARE(document().undoStack()->count(), edits);

        document().selectVertex(VertexRef{0, 1});
        Canvas *canvas = m_window->parts().canvas;
        QTest::keyClick(canvas, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(corner(), latticePixel(28, 28));
        QTest::keyClick(canvas, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(corner(), latticePixel(27, 27));
    }

    void aPolygonIsFilledByEitherRuleAndATriangleHasNoForms()
    {
        Scene scene = fourPrimitives();
        scene.shapes[0].kind = PrimitiveKind::Polygon;
        scene.shapes[0].fill = ShapeFill::EvenOdd;
        scene.shapes[0].vertices.push_back({latticePixel(9, 9), red});
        document().reset(scene);
        const auto *button = named<QToolButton>(*m_window, "primitivesForm");
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(0));
        QVERIFY(!button->isEnabled());
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(2));
        QVERIFY(button->isEnabled());
        QCOMPARE(checkedForms(), QStringList("Filled by parity (even-odd)"));
        takeForm("Filled by winding number (non-zero)");
        QCOMPARE(document().shapeAt(2).fill, ShapeFill::NonZero);
        takeForm("Outlined");
        QCOMPARE(document().shapeAt(2).fill, ShapeFill::Outline);
        m_tree->setCurrentIndex(m_model->indexOfPrimitive(3)); // a line
        QVERIFY(!button->isEnabled());
    }

private:
    QMenu &forms() const
    {
        return *named<QToolButton>(*m_window, "primitivesForm")->defaultAction()->menu();
    }

    QStringList checkedForms() const
    {
        QStringList texts;
        for (const QAction *form : forms().actions()) {
            if (form->isChecked())
                texts.append(form->text());
        }
        return texts;
    }

    void takeForm(const char *text) const
    {
        const QList<QAction *> all = forms().actions();
        const auto found = std::ranges::find(all, QString::fromUtf8(text), &QAction::text);
        QVERIFY(found != all.end());
        (*found)->trigger();
    }

    SceneDocument &document() const { return *m_window->parts().document; }

    QModelIndex cellOf(int vertex, PrimitiveListModel::Column column) const
    {
        return m_model->index(vertex, column, m_model->indexOfPrimitive(0));
    }

    static QLineEdit *field() { return qobject_cast<QLineEdit *>(QApplication::focusWidget()); }

    static void typeOver(const char *text)
    {
        QTRY_VERIFY(field());
        field()->selectAll();
        QTest::keyClicks(field(), QLatin1String(text));
    }

    static void takeAmber()
    {
        QTimer::singleShot(0, qApp, [] {
            auto *dialog = qobject_cast<QColorDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            dialog->setCurrentColor(QColor(255, 176, 0));
            dialog->accept();
        });
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    QTreeView *m_tree = nullptr;
    PrimitiveListModel *m_model = nullptr;
};

PIXELPLUMB_TEST(TestPrimitivesTree)

} // namespace tst_primitivestree

#include "tst_primitivestree.moc"
