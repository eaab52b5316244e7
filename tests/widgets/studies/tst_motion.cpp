// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/casegallery.h"
#include "core/compare/motionstudy.h"
#include "core/methods/method.h"
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/accuracy/motionpanel.h"
#include "widgets/studies/accuracy/motionview.h"

#include <QTest>
#include <QtWidgets>

namespace tst_motion {

using namespace pixelplumb;

namespace {

Scene movingScene() { return readSceneFile(resource(u"/scenes/moving-sliver.json"_s))->scene; }

Scene exactly(Scene scene)
{
    scene.settings.arithmetic = Arithmetic::Exact;
    return scene;
}

} // namespace

/// Scenes that move, and what flickers in them.
class TestMotion : public QObject {
    Q_OBJECT

private slots:
    void aFrameIsAPartOfTheWay()
    {
        Scene scene = movingScene();
        scene.motion = Motion{{1000, -7}, 4};
        const LatticePoint from = scene.triangles.front().vertices[0].position;
        const auto at = [&](int frame) {
            const LatticePoint point
                = sceneAtFrame(scene, frame).triangles.front().vertices[0].position;
            return std::pair(point.x - from.x, point.y - from.y);
        };
        QCOMPARE(at(0), std::pair(Lattice(0), Lattice(0)));
        QCOMPARE(at(1), std::pair(Lattice(333), Lattice(-2))); // 333 1/3, −2 1/3
        QCOMPARE(at(2), std::pair(Lattice(667), Lattice(-5))); // 666 2/3, −4 2/3
        QCOMPARE(at(3), std::pair(Lattice(1000), Lattice(-7)));
    }

    void theSequencesOfTheHardCasesCountAsTheirFactsSay()
    {
        int sequences = 0;
        for (const GalleryCase &entry : gallery()) {
            if (entry.hardCase.kind != HardCaseKind::Sequence)
                continue;
            for (const auto &[rule, facts] : entry.hardCase.facts) {
                const Method &method = *methodNamed(rule == FillRule::TopLeft ? u"edge-equations"_s
                                                                              : u"column-scan"_s);
                if (!method.supports(rule) || !facts.toggles)
                    continue;
                ScanSettings settings;
                settings.fillRule = rule;
                const auto study = studyMotion(sceneOf(entry.hardCase, method, settings));
                std::vector<std::int64_t> counts;
                for (const MotionFrame &frame : study->frames) {
                    counts.push_back(frame.drawn);
                    QCOMPARE(frame.drawn, frame.truth);
                    QCOMPARE(frame.toggled, frame.truthToggled);
                }
                QCOMPARE(counts, facts.frameCounts);
                QCOMPARE(study->toggled(), *facts.toggles);
                ++sequences;
            }
        }
        QVERIFY(sequences >= 5);
    }

    void whatAPixelTogglesAddsUpToWhatFramesToggle()
    {
        const Scene scene = movingScene();
        const MotionStudy study = *studyMotion(scene);
        std::int64_t drawn = 0;
        std::int64_t truth = 0;
        for (int y = 0; y < scene.frame.height; ++y) {
            for (int x = 0; x < scene.frame.width; ++x) {
                drawn += study.toggles.at(x, y).drawn;
                truth += study.toggles.at(x, y).truth;
            }
        }
        QCOMPARE(drawn, study.toggled());
        QCOMPARE(truth, study.truthToggled());
        QVERIFY(truth > 0);
        QCOMPARE(studyMotion(exactly(scene))->toggled(), truth);
    }

    void aStudyCanBeEnded()
    {
        int heard = 0;
        QVERIFY(!studyMotion(movingScene(), [&heard](const JobProgress &) { return ++heard < 4; }));
        QCOMPARE(heard, 4);
    }

    void theFileKeepsTheMotion()
    {
        const Scene scene = movingScene();
        QCOMPARE(readScene(writeScene(scene, {}))->scene, scene);
        for (const char *wrong :
             {"{ \"by\": [1, 2] }", "{ \"by\": [1, 2], \"frames\": 1 }",
              "{ \"by\": 3, \"frames\": 5 }", "{ \"by\": [1, 2], \"frames\": 2.5 }",
              "{ \"by\": [1, 2], \"frames\": 5, \"speed\": 1 }"}) {
            const auto reading
                = readScene(QByteArray("{ \"pixelplumb\": 1, \"frame\": { \"width\": 8, "
                                       "\"height\": 8 }, \"motion\": ")
                            + wrong + ", \"primitives\": [] }");
            QVERIFY2(!reading, wrong);
            QVERIFY2(reading.error().place.startsWith(u"motion"_s)
                         || reading.error().place.contains(u"motion"_s),
                     qPrintable(reading.error().place));
        }
    }

    void theCommandTellsEveryFrame()
    {
        const QString file = sceneFile(u"moving-sliver.json"_s);
        const MotionStudy study = *studyMotion(movingScene());
        const ProgramRun result = run({u"motion"_s, file});
        QCOMPARE(result.exitCode, study.toggled() == study.truthToggled() ? 0 : 1);
        QCOMPARE(result.output.count('\n'), qsizetype(study.frames.size()) + 2);
        const ProgramRun json
            = run({u"motion"_s, file, u"--json"_s, u"--arithmetic"_s, u"exact"_s});
        QCOMPARE(json.exitCode, 0);
        QCOMPARE(QJsonDocument::fromJson(json.output)[u"toggled"_s].toInteger(),
                 study.truthToggled());
    }

    void oneFrameIsDrawnAndNoOther()
    {
        const QString file = sceneFile(u"moving-sliver.json"_s);
        const QStringList draw = {u"render"_s, file, u"--ascii"_s, u"--frame"_s};
        const MotionStudy study = *studyMotion(movingScene());
        for (const int frame : {0, 7, 24}) {
            const ProgramRun result = run(draw + QStringList{QString::number(frame)});
            QCOMPARE(result.exitCode, 0);
            QCOMPARE(result.output.count('#'), study.frames[std::size_t(frame)].drawn);
        }
        QCOMPARE(run(draw + QStringList{u"25"_s}).exitCode, 2);
        const ProgramRun still
            = run({u"render"_s, sceneFile(u"default.json"_s), u"--ascii"_s, u"--frame"_s, u"1"_s});
        QCOMPARE(still.exitCode, 2);
        QVERIFY2(still.messages.contains("does not move"), still.messages.constData());
    }

    void theWindowCountsAndShowsTheFrames()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow(movingScene());
        action(*window, "motionDockToggle")->trigger();
        auto *panel = named<MotionPanel>(*window, "motion");
        QTRY_VERIFY(panel->study().has_value());
        const MotionStudy study = *studyMotion(movingScene());
        const auto *table = named<QTableView>(*window, "motionTable");
        QCOMPARE(table->model()->rowCount(), int(study.frames.size()));
        QCOMPARE(table->model()->index(5, 2).data().toString(),
                 QString::number(study.frames[5].toggled));
        auto *slider = named<QSlider>(*window, "motionSlider");
        for (const int frame : {5, 9}) {
            slider->setValue(frame);
            QTRY_COMPARE(
                std::int64_t(named<MotionView>(*window, "motionView")->picture().toggled.size()),
                study.frames[std::size_t(frame)].toggled);
        }
        QVERIFY(named<QLabel>(*window, "motionSummary")
                    ->text()
                    .contains(QString::number(study.toggled())));
    }

    void theFrameOfTheSliderIsWhatIsSeenAndStepped()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow(movingScene());
        window->resize(1366, 768);
        SceneDocument &document = *window->parts().document;
        const Playhead &playhead = *window->parts().playhead;
        Canvas &canvas = *window->parts().canvas;
        action(*window, "motionDockToggle")->trigger();
        auto *slider = named<QSlider>(*window, "motionSlider");
        const auto isAt = [&](int frame) {
            Scene moved = sceneAtFrame(movingScene(), frame);
            moved.motion = playhead.traced()->scene.motion; // is not compared
            return playhead.traced()->scene == moved;
        };
        slider->setFocus();
        for (int i = 0; i < 8; ++i)
            QTest::keyClick(slider, Qt::Key_Right);
        QTRY_VERIFY(isAt(8));
        QVERIFY(!document.isModified());
        QCOMPARE(document.undoStack()->count(), 0);
        QCOMPARE(document.scene(), movingScene());

        // 8 of 24 frames: by 4/3 and 1 px; a handle is where the vertex is shown, and moves the
        // scene's vertex.
        const LatticePoint start = movingScene().triangles.front().vertices[0].position;
        const LatticePoint seen = sceneAtFrame(movingScene(), 8).triangles[0].vertices[0].position;
        canvas.setTool(CanvasTool::Draw);
        QCOMPARE(canvas.vertexAt(canvas.positionOf(seen)), std::optional(VertexRef{0, 0}));
        QVERIFY(!canvas.vertexAt(canvas.positionOf(start)));
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.positionOf(QPoint(20, 3)).toPoint());
        QCOMPARE(document.atCurrentFrame(document.pendingVertices().front().position),
                 latticePixel(20, 3));
        QTest::keyClick(&canvas, Qt::Key_Escape);

        auto *table = named<QTableView>(*window, "motionTable");
        QTRY_COMPARE(table->model()->rowCount(), 25);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(11, 1)).center());
        QTRY_VERIFY(isAt(11));
        QCOMPARE(slider->value(), 11);
        QTest::mouseClick(named<QToolButton>(*window, "motionPlay"), Qt::LeftButton);
        QTRY_VERIFY(isAt(13));
        QTest::mouseClick(named<QToolButton>(*window, "motionPlay"), Qt::LeftButton);

        // The steps are those of this frame, even if another panel is in front.
        const int frame = slider->value();
        action(*window, "columnsDockToggle")->trigger();
        action(*window, "runToEnd")->trigger();
        QVERIFY(isAt(frame));
        const Scene moved = sceneAtFrame(movingScene(), frame);
        const FrameBuffer drawn(moved.frame);
        drawScene(moved, drawn);
        QCOMPARE(playhead.frame()->copy(), drawn.copy());
    }

    void aDraggedVertexSnapsWhereItIsSeen()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow(movingScene());
        window->resize(1366, 768);
        SceneDocument &document = *window->parts().document;
        Canvas &canvas = *window->parts().canvas;
        document.setCurrentFrame(8); // by 4/3 and 1 px
        QTRY_COMPARE(window->parts().playhead->traced()->scene.triangles,
                     sceneAtFrame(movingScene(), 8).triangles);
        canvas.setTool(CanvasTool::Draw);
        const LatticePoint seen = sceneAtFrame(movingScene(), 8).triangles[0].vertices[0].position;
        const QPoint press = canvas.positionOf(seen).toPoint();
        const QPoint target = canvas.positionOf(QPoint(12, 14)).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, press);
        QTest::mouseMove(&canvas, target);
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, target);

        QCOMPARE(document.atCurrentFrame(document.vertexAt({0, 0})->position),
                 latticePixel(12, 14));
        QCOMPARE(canvas.spokenState(),
                 u"vertex 0 of triangle 0 at (12, 14), frame 8 of 24 of the motion"_s);
    }

    void aSceneThatIsOpenedBeginsAtItsFirstFrame()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow(movingScene());
        action(*window, "motionDockToggle")->trigger();
        auto *slider = named<QSlider>(*window, "motionSlider");
        slider->setValue(20);
        QTRY_COMPARE(window->parts().document->currentFrame(), 20);
        Scene other = movingScene();
        other.motion = Motion{{256, 0}, 11};
        window->parts().document->reset(other);
        QCOMPARE(window->parts().document->currentFrame(), 0);
        QCOMPARE(slider->value(), 0);
        QCOMPARE(window->parts().playhead->traced()->scene.triangles, other.triangles);
    }

    void theThumbnailShowsTheOutlineAndWhatTheTruthHasBeside()
    {
        const MotionStudy study = *studyMotion(movingScene());
        int frames = 0;
        for (int frame = 0; frame < int(study.frames.size()); ++frame) {
            const MotionPicture picture = motionPicture(movingScene(), frame);
            const MotionFrame &counted = study.frames[std::size_t(frame)];
            QVERIFY(std::int64_t(picture.missing.size()) >= counted.truth - counted.drawn);
            QVERIFY(std::int64_t(picture.missing.size()) <= counted.truth);
            frames += int(!picture.missing.empty());
            QCOMPARE(picture.outlines.size(), std::size_t(1));
            QCOMPARE(picture.outlines.front().front(),
                     sceneAtFrame(movingScene(), frame).triangles[0].vertices[0].position);
        }
        QVERIFY(frames > 0); // float32 loses pixels of this sliver
    }

    void allColumnsOfTheTableAreInView()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow(movingScene());
        window->resize(1366, 768);
        action(*window, "motionDockToggle")->trigger();
        auto *table = named<QTableView>(*window, "motionTable");
        QTRY_COMPARE(table->model()->rowCount(), 25);
        QTRY_VERIFY(table->columnViewportPosition(3) + table->columnWidth(3)
                    <= table->viewport()->width());
        QVERIFY(!table->horizontalScrollBar()->isVisible());
    }

    void aStillSceneTakesNoRoomForWhatIsNotThere()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow();
        action(*window, "motionDockToggle")->trigger();
        QTest::qWait(50);
        const auto *panel = named<MotionPanel>(*window, "motion");
        const int still = panel->sizeHint().height();
        QVERIFY(!named<QWidget>(*window, "motionTable")->isVisible());
        QVERIFY(still < 200);

        QTest::mouseClick(named<QPushButton>(*window, "motionSet"), Qt::LeftButton);

        auto *table = named<QTableView>(*window, "motionTable");
        QVERIFY(table->isVisible());
        QTRY_VERIFY(panel->height() > still);
        for (int column = 0; column < table->model()->columnCount(); ++column)
            QVERIFY(table->columnWidth(column)
                    >= table->horizontalHeader()->sectionSizeHint(column));
    }

    void aStillSceneIsSetMovingAndStopped()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        action(*window, "motionDockToggle")->trigger();
        auto *x = named<QLineEdit>(*window, "motionX");
        x->setText(u"much"_s);
        QTest::mouseClick(named<QPushButton>(*window, "motionSet"), Qt::LeftButton);
        QVERIFY(!document.scene().motion);
        QVERIFY(named<QLabel>(*window, "motionSummary")->text().contains(u"much"_s));
        x->setText(u"1/2"_s);
        QTest::mouseClick(named<QPushButton>(*window, "motionSet"), Qt::LeftButton);
        QCOMPARE(document.scene().motion, std::optional(Motion{{128, 512}, 33}));
        QVERIFY(document.isModified());
        QTRY_VERIFY(named<MotionPanel>(*window, "motion")->study().has_value());
        document.undoStack()->undo();
        QVERIFY(!document.scene().motion);
        document.undoStack()->redo();
        QTest::mouseClick(named<QPushButton>(*window, "motionEnd"), Qt::LeftButton);
        QVERIFY(!document.scene().motion);
    }

private:
    static std::vector<GalleryCase> gallery()
    {
        std::vector<GalleryCase> all;
        for (const char *name : {"hard_cases.json", "more_cases.json"}) {
            QFile file(testData(QString::fromLatin1(name)));
            if (!file.open(QIODevice::ReadOnly))
                continue;
            const auto read = readGallery(file.readAll());
            if (read)
                all.insert(all.end(), read->begin(), read->end());
        }
        return all;
    }
};

PIXELPLUMB_TEST(TestMotion)

} // namespace tst_motion

#include "tst_motion.moc"
