// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/space/projectionpanel.h"
#include "widgets/space/sideview.h"
#include "widgets/space/stagetree.h"
#include "widgets/space/surfacespanel.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_projectiondock {

using namespace pixelplumb;

namespace {

constexpr int longest = 60'000; // ms

/// A plain triangle, a triangle that the near plane clips, and a sphere.
Scene spaceScene()
{
    Scene scene = sceneOf(
        {triangle3({-1, -0.5, 2}, {1, -0.5, 2}, {0, 1, 5.5}), solidOf(SolidKind::Sphere)});
    scene.triangles = {triangleAt(3, 4, 50, 10, 20, 40)};
    return scene;
}

/// A panel that has projected a scene.
struct Bench {
    explicit Bench(const Scene &scene = spaceScene())
    {
        panel.show();
        QSignalSpy spy(&panel, &ProjectionPanel::projected);
        playhead.setTraced(traceScene(scene));
        if (spy.count() == 0 && !spy.wait(longest))
            qFatal("not projected");
    }

    QString sentence() const { return named<QLabel>(panel, "projectionSentence")->text(); }

    Playhead playhead;
    SceneDocument document;
    ProjectionPanel panel{&document, &playhead};
    const StageTree *tree = named<StageTree>(panel, "stageTree");
};

/// The step that writes a primitive's first sample, or its set-up.
std::size_t positionIn(const Playhead &playhead, std::size_t primitive)
{
    const ScanTrace &trace = *playhead.traced()->trace;
    for (std::size_t step = trace.indexOfSetUp(primitive); step < trace.stepCount(); ++step) {
        if (trace.stepAt(step).kind == StepKind::Sample)
            return step + 1;
    }
    return trace.indexOfSetUp(primitive) + 1;
}

QTreeWidgetItem *stageItem(const StageTree &tree, const QString &title)
{
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        if (tree.topLevelItem(i)->text(0) == title)
            return tree.topLevelItem(i);
    }
    return nullptr;
}

/// The text of a number at a stage's point.
QString cell(const StageTree &tree, const QString &title, int point, int number, int column)
{
    // The first row below a stage is its formula.
    return stageItem(tree, title)->child(point + 1)->child(number)->text(column);
}

QStringList notesOf(const StageTree &tree, const QString &title)
{
    QStringList notes;
    const QTreeWidgetItem *item = stageItem(tree, title);
    for (int i = 1; i < item->childCount(); ++i)
        notes += item->child(i)->text(0);
    return notes;
}

} // namespace

/// The dock that shows how a triangle got from three dimensions to the frame.
class TestProjectionDock : public QObject {
    Q_OBJECT

private slots:
    void followsTheStepThroughTheSolidsTriangles()
    {
        Bench bench;

        bench.playhead.seek(positionIn(bench.playhead, 0));
        QVERIFY2(bench.sentence().startsWith(u"The scene's solids become"_s),
                 qPrintable(bench.sentence()));
        QCOMPARE(bench.tree->topLevelItemCount(), 0);

        bench.playhead.seek(positionIn(bench.playhead, 1));
        QVERIFY2(bench.sentence().contains(u"C₀ C₁ C₂ of face 0 of solid 0"_s),
                 qPrintable(bench.sentence()));
        QCOMPARE(bench.tree->topLevelItemCount(), 7);

        bench.playhead.seek(positionIn(bench.playhead, 2));
        QVERIFY2(bench.sentence().contains(u"C₀ C₂ C₃ of face 0 of solid 0"_s),
                 qPrintable(bench.sentence()));

        bench.playhead.seek(positionIn(bench.playhead, 20));
        QVERIFY2(bench.sentence().contains(u"of solid 1, a sphere"_s),
                 qPrintable(bench.sentence()));
    }

    void showsTheEdgesThatTheNearPlaneCutsAndTheSnapsDisplacement()
    {
        Bench bench;
        bench.playhead.seek(positionIn(bench.playhead, 1));

        QCOMPARE(
            notesOf(*bench.tree, u"Clipped polygon"_s),
            (QStringList{u"C₀: V₀, kept"_s, u"C₁: V₁, kept"_s, u"C₂: the near plane cuts V₁V₂"_s,
                         u"C₃: the near plane cuts V₀V₂"_s}));
        // Depths 3 and −0.5: t = 2/3.5.
        QVERIFY(cell(*bench.tree, u"Clipped polygon"_s, 2, 0, StageTree::ExactColumn)
                    .startsWith(u"0.57142857142857142857"_s));
        const Triangle &drawn = bench.playhead.traced()->primitives.triangles[1];
        const double x = double(drawn.vertices[0].position.x) / 256;
        QCOMPARE(cell(*bench.tree, u"Lattice"_s, 0, 0, StageTree::UsedColumn)
                     .replace(QChar(0x2212), u'-')
                     .toDouble(),
                 x);
        const double displacement = cell(*bench.tree, u"Lattice"_s, 0, 0, StageTree::ErrorColumn)
                                        .replace(QChar(0x2212), u'-')
                                        .toDouble();
        QVERIFY(displacement != 0 && std::abs(displacement) <= 1.0 / 512);
    }

    void whatIsFoldedStaysFolded()
    {
        Bench bench;
        bench.playhead.seek(positionIn(bench.playhead, 1));
        stageItem(*bench.tree, u"Camera"_s)->setExpanded(false);

        bench.playhead.seek(positionIn(bench.playhead, 20));

        QVERIFY(!stageItem(*bench.tree, u"Camera"_s)->isExpanded());
        QVERIFY(stageItem(*bench.tree, u"Division"_s)->isExpanded());
    }

    void saysWhatItWouldShowWhereThereAreNoSolids()
    {
        Scene scene;
        scene.triangles = {triangleAt(3, 4, 50, 10, 20, 40)};
        const Bench bench(scene);

        QVERIFY(bench.sentence().startsWith(u"This scene has no solids."_s));
        QVERIFY(!named<SideView>(bench.panel, "sideView")->isVisible());
    }

    void tellsWhyFacesAreNotDrawn()
    {
        Scene scene = spaceScene();
        scene.solids.push_back(triangle3({0, 0, 6}, {1, 0, 7}, {0, 1, 8}));
        const Bench bench(scene);

        const QString text = bench.sentence();
        QVERIFY2(text.contains(u"1: each has no part beyond the near plane"_s), qPrintable(text));
    }

    void aDragTurnsTheSideViewAndADoubleClickPutsItBack()
    {
        SideView view;
        view.resize(400, 300);
        view.setScene(sideSceneOf(spaceScene()));
        view.show();
        const SpaceVector<double> eye;
        const QPointF before = view.positionOf(eye);

        QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(&view, {180, 120});
        QTest::mouseRelease(&view, Qt::LeftButton, {}, {180, 120});

        QCOMPARE(view.orbit().turn(), OrbitView::firstTurn + 40);
        QCOMPARE(view.orbit().tilt(), OrbitView::firstTilt + 10);
        QVERIFY(view.positionOf(eye) != before);
        QTest::mouseDClick(&view, Qt::LeftButton);
        QCOMPARE(view.positionOf(eye), before);
        QTest::keyClick(&view, Qt::Key_Left);
        QCOMPARE(view.orbit().turn(), OrbitView::firstTurn - 5);
    }

    void untouchedTheEyeLooksToTheRightAndEverythingFits()
    {
        OrbitView view;
        view.turnBy(-OrbitView::firstTurn, -OrbitView::firstTilt);
        const QRectF rect(10, 20, 300, 200);
        const std::vector<SpaceVector<double>> points
            = {{0, 0, 0}, {-1, -1, -3}, {1, 2, -6}, {0.5, 1, -4}};
        view.fit(points, rect);

        const QPointF eye = view.positionOf({0, 0, 0});
        const QPointF target = view.positionOf({0, 0, -3});
        const QPointF above = view.positionOf({0, 1, 0});
        QVERIFY(target.x() > eye.x());
        QCOMPARE(target.y(), eye.y());
        QCOMPARE(above.x(), eye.x());
        QVERIFY(above.y() < eye.y());
        for (const auto &point : points)
            QVERIFY(rect.adjusted(-1, -1, 1, 1).contains(view.positionOf(point)));
    }

    void theRaysMeetThePicturePlaneWhereTheFrameSaysSo()
    {
        const Scene scene = spaceScene();
        const ProjectedSolids projected = projectedSolids(scene);
        const SideScene side = sideSceneOf(scene);
        const FaceStages stages = stagesOf(scene, projected, 3);

        const SideFace face = sideFaceOf(scene, side, stages, projected.sources[3], {});

        const SpaceVector<double> corner = side.picturePlane[2];
        for (std::size_t i = 0; i < face.picture.size(); ++i) {
            QVERIFY(std::abs(face.picture[i].x / corner.x - stages.face.devices[i].x) < 1e-12);
            QVERIFY(std::abs(face.picture[i].y / corner.y - stages.face.devices[i].y) < 1e-12);
        }
        // The ray of a sample inside the triangle meets the triangle's plane within the sphere's
        // depths.
        const auto &place = stages.face.places;
        const QPoint pixel(qRound((place[0][0] + place[1][0] + place[2][0]) / 3),
                           qRound((place[0][1] + place[1][1] + place[2][1]) / 3));
        const SideFace sampled = sideFaceOf(scene, side, stages, projected.sources[3], pixel);
        QVERIFY(sampled.sample.has_value());
        QVERIFY(std::abs(sampled.sample->face.z + 5) <= 1.1);
    }

    void theFormsFollowTheirParameters()
    {
        Playhead playhead;
        SceneDocument document;
        SurfacesPanel panel(&document, &playhead);
        playhead.setTraced(traceScene(spaceScene()));
        panel.show();

        const auto *forms = named<QTextBrowser>(panel, "surfaceForms");
        const QString before = forms->toPlainText();
        named<QSlider>(panel, "surfaceS")->setValue(100);
        const QString after = forms->toPlainText();
        QVERIFY(after != before);
        // Halfway from (1, 2) to (7, 5).
        QVERIFY2(after.contains(u"x = 4 (exact)"_s), qPrintable(after));
        QVERIFY2(after.contains(u"y = 3.5 (exact)"_s), qPrintable(after));
    }

    void opensByItsKeyInBothPalettes_data() { addPalettes(); }
    void opensByItsKeyInBothPalettes()
    {
        QFETCH(QPalette, palette);
        const auto window = openedWindow(spaceScene());
        qApp->setPalette(palette);
        QVERIFY(waitForRun(*window));
        QAction *toggle = action(*window, "projectionDockToggle");
        QCOMPARE(toggle->shortcut(), QKeySequence(u"Alt+Shift+1"_s));
        auto *playhead = window->findChild<Playhead *>();
        playhead->seek(positionIn(*playhead, 1));

        toggle->trigger();

        auto *panel = named<ProjectionPanel>(*window, "projectionPanel");
        auto *view = named<SideView>(*window, "sideView");
        QTRY_VERIFY(panel->isVisible());
        QTRY_VERIFY(view->height() > 150);
        grabbed(*window, u"projection"_s);
        QTRY_COMPARE(readingFault(*view), QString());
        QTRY_COMPARE(readingFault(*panel), QString());
        named<QTabWidget>(*window, "projectionTabs")->setCurrentIndex(1);
        auto *surfaces = named<SurfacesPanel>(*window, "surfacesPanel");
        grabbed(*window, u"surfaces"_s);
        QTRY_COMPARE(readingFault(*surfaces), QString());
    }
};

PIXELPLUMB_TEST(TestProjectionDock)

} // namespace tst_projectiondock

#include "tst_projectiondock.moc"
