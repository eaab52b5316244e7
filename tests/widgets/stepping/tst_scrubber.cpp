// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/steptext.h"
#include "widgets/stepping/scrubber.h"

#include <QAccessible>
#include <QtTest>

namespace tst_scrubber {

using namespace pixelplumb;

namespace {

std::shared_ptr<const TracedScene> traced(VariantSet variants = {})
{
    Scene scene;
    scene.settings.variants = variants;
    scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
    return traceScene(scene);
}

/// A scrubber on a traced scene.
struct Stage {
    Playhead playhead;
    Scrubber scrubber{&playhead};

    Stage()
    {
        playhead.setTraced(traced());
        scrubber.resize(800, scrubber.sizeHint().height());
        scrubber.show();
    }
    QPoint at(std::size_t position) const
    {
        return {int(std::lround(scrubber.scale().xOf(position))), scrubber.height() / 2};
    }
};

} // namespace

class TestScrubber : public QObject {
    Q_OBJECT

private slots:
    void itsScaleGoesThereAndBack_data()
    {
        QTest::addColumn<qulonglong>("end");
        QTest::newRow("no step") << 0ULL;
        QTest::newRow("one step") << 1ULL;
        QTest::newRow("a small triangle") << 1320ULL;
        QTest::newRow("eight million steps") << 8'400'000ULL;
    }
    void itsScaleGoesThereAndBack()
    {
        QFETCH(qulonglong, end);
        const ScrubberScale scale{72, 700, std::size_t(end)};
        for (const std::size_t position : {std::size_t(0), std::size_t(end / 3), std::size_t(end)})
            QCOMPARE(scale.positionAt(scale.xOf(position)), position);
        QCOMPARE(scale.positionAt(-50), std::size_t(0));
        QCOMPARE(scale.positionAt(5000), std::size_t(end));
    }

    void theNamesOfTheLanesAreExplained()
    {
        Stage stage;
        const auto told = [&](const QPoint &at) {
            QHelpEvent help(QEvent::ToolTip, at, stage.scrubber.mapToGlobal(at));
            QCoreApplication::sendEvent(&stage.scrubber, &help);
            return QToolTip::text();
        };
        const char *meanings[] = {"corner", "exactly on an edge", "0 … 255", "differs"};
        for (int lane = 0; lane < 4; ++lane)
            QVERIFY2(told({40, 9 + 11 * lane}).contains(QString::fromUtf8(meanings[lane])),
                     qPrintable(told({40, 9 + 11 * lane})));
        QVERIFY2(told({40, 9 + 11 * 4}).startsWith(u"step 0"_s), qPrintable(QToolTip::text()));
    }

    void columnsThatAreSeenStandOnThemselves()
    {
        const std::array<ColumnStop, 3> stops = {{{2, 110}, {7, 120}, {30, 130}}};
        const ScrubberScale scale{100, 35, 44, stops};
        QCOMPARE(scale.xOf(0), 100.0);
        QCOMPARE(scale.xOf(2), 110.0);
        QCOMPARE(scale.xOf(6), 110.0);
        QCOMPARE(scale.xOf(44), 130.0);
        QCOMPARE(scale.positionAt(-5), std::size_t(0));
        QCOMPARE(scale.positionAt(104), std::size_t(0));
        QCOMPARE(scale.positionAt(106), std::size_t(2));
        QCOMPARE(scale.positionAt(114), std::size_t(2));
        QCOMPARE(scale.positionAt(116), std::size_t(7));
        QCOMPARE(scale.positionAt(134), std::size_t(30));
        QCOMPARE(scale.positionAt(135), std::size_t(44));
    }

    void thePlumbLineOfTheWindowIsOneLine()
    {
        const IsolatedSettings settings;
        const auto window = openedWindow();
        const Canvas &canvas = *window->parts().canvas;
        Playhead &playhead = *window->parts().playhead;
        const Scrubber &scrubber = *window->parts().scrubber;
        for (int zoom : {canvas.zoom(), 6, 4, 24, 40}) {
            window->parts().canvas->setZoom(zoom);
            for (std::size_t position = 2; position <= playhead.end(); position += 97) {
                playhead.seek(position);
                const double x = canvas.positionOf(QPoint(int(*playhead.currentColumnX()), 0)).x();
                QVERIFY(x >= canvas.view().left() && x <= canvas.view().right());
                QCOMPARE(
                    canvas.mapTo(window.get(), QPointF(x, 0)).x(),
                    scrubber.mapTo(window.get(), QPointF(scrubber.scale().xOf(position), 0)).x());
            }
        }
    }

    void theMarkOfTheFirstWrongPixelHasALaneOfItsOwn()
    {
        Stage stage;
        const QImage right = stage.scrubber.grab().toImage();
        stage.playhead.setTraced(traced(VariantSet().with(Variant::NoColourPreStep)));
        const QImage wrong = stage.scrubber.grab().toImage();

        std::set<int> lines;
        for (int y = 0; y < right.height(); ++y) {
            for (int x = 0; x < right.width(); ++x) {
                if (right.pixel(x, y) != wrong.pixel(x, y))
                    lines.insert(y);
            }
        }
        QVERIFY(!lines.empty());
        const int lane = 11;
        QVERIFY2(*lines.begin() >= 4 + 3 * lane, qPrintable(QString::number(*lines.begin())));
        QVERIFY2(*lines.rbegin() < 4 + 4 * lane, qPrintable(QString::number(*lines.rbegin())));
    }

    void theMarkOfTheFirstDifferenceNamesThePixelThatDiffers_data()
    {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<QString>("told");
        // A line drawn only to (29, 44), by a loop that ends one step too early.
        const Colour white = {{255, 255, 255}};
        Shape line;
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(20, 41), white}, {latticePixel(30, 44), white}};
        Scene shortLine;
        shortLine.method = "line-bresenham";
        shortLine.shapes = {line};
        shortLine.settings.variants = VariantSet().with(Variant::OneStepShort);
        QTest::newRow("missing in the end")
            << shortLine << "pixel (30, 44) is missing when the run ends";
        // (int)(5 + .5) … (int)(44 − .5): the topmost row is not visited.
        Scene box;
        box.method = "edge-equations";
        box.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
        box.settings.variants = VariantSet().with(Variant::RoundedBox);
        QTest::newRow("missing on the way") << box
                                            << "pixel (58, 12) is missing, and this step was "
                                               "the last that could have drawn it";
        Scene colours = box;
        colours.method = "column-scan";
        colours.settings.variants = VariantSet().with(Variant::UnsortedColours);
        std::swap(colours.triangles[0].vertices[0], colours.triangles[0].vertices[1]);
        QTest::newRow("colour") << colours << "pixel (4, 5) has another colour";
    }
    void theMarkOfTheFirstDifferenceNamesThePixelThatDiffers()
    {
        QFETCH(Scene, scene);
        QFETCH(QString, told);
        const auto traced = traceScene(scene);
        const auto mark
            = std::ranges::find(traced->marks, MarkKind::FirstDifference, &TraceMark::kind);
        QVERIFY(mark != traced->marks.end());

        QCOMPARE(markText(*traced, *mark), u"first difference from the truth: "_s + told);
    }

    void aDragSeeksLive()
    {
        Stage stage;
        QTest::mousePress(&stage.scrubber, Qt::LeftButton, {}, stage.at(200));
        const std::size_t pressed = stage.playhead.position();
        const QPoint target = stage.at(900);
        QTest::mouseMove(&stage.scrubber, target);
        const std::size_t expected = stage.scrubber.scale().positionAt(target.x());

        QTRY_COMPARE(stage.playhead.position(), expected);
        QVERIFY(pressed < expected);
        QTest::mouseRelease(&stage.scrubber, Qt::LeftButton, {}, target);
        QCOMPARE(stage.playhead.position(), expected);
    }

    void manyMovesWithinAFrameAreOneSeek()
    {
        Stage stage;
        QTest::mousePress(&stage.scrubber, Qt::LeftButton, {}, stage.at(0));
        const QSignalSpy moves(&stage.playhead, &Playhead::positionChanged);
        for (std::size_t position = 10; position <= 1000; position += 10) {
            const QPoint point = stage.at(position);
            QMouseEvent move(QEvent::MouseMove, point, stage.scrubber.mapToGlobal(point),
                             Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&stage.scrubber, &move);
        }
        QTest::mouseRelease(&stage.scrubber, Qt::LeftButton, {}, stage.at(1000));

        QCOMPARE(moves.size(), 1);
    }

    void aClickNearAMarkGoesToTheMark()
    {
        Stage stage;
        const std::vector<TraceMark> &marks = stage.playhead.traced()->marks;
        const auto mark = std::ranges::find_if(
            marks, [](const TraceMark &each) { return each.step > 200 && each.step < 1000; });
        QVERIFY(mark != marks.end());

        QTest::mouseClick(&stage.scrubber, Qt::LeftButton, {},
                          stage.at(mark->step + 1) + QPoint(2, 0));

        QVERIFY(std::ranges::any_of(marks, [&](const TraceMark &each) {
            return each.step + 1 == stage.playhead.position();
        }));
    }

    void controlAndArrowsGoFromMarkToMark()
    {
        Stage stage;
        stage.playhead.seek(0);
        std::set<std::size_t> expected;
        for (const TraceMark &mark : stage.playhead.traced()->marks)
            expected.insert(mark.step + 1);
        std::set<std::size_t> visited;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QTest::keyClick(&stage.scrubber, Qt::Key_Right, Qt::ControlModifier);
            visited.insert(stage.playhead.position());
        }
        QCOMPARE(visited, expected);

        QTest::keyClick(&stage.scrubber, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(stage.playhead.position(), *std::next(expected.rbegin()));
    }

    void theArrowsStepByTheChosenUnit()
    {
        Stage stage;
        stage.playhead.setUnit(StepUnit::Sample);
        stage.playhead.seek(10);
        QTest::keyClick(&stage.scrubber, Qt::Key_Right);
        QCOMPARE(stage.playhead.position(), std::size_t(11));
        QTest::keyClick(&stage.scrubber, Qt::Key_Home);
        QCOMPARE(stage.playhead.position(), std::size_t(0));
        QTest::keyClick(&stage.scrubber, Qt::Key_End);
        QCOMPARE(stage.playhead.position(), stage.playhead.end());
    }

    void assistiveTechnologyReadsAndSetsThePosition()
    {
        Stage stage;
        QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(&stage.scrubber);
        QVERIFY(accessible);
        QAccessibleValueInterface *value = accessible->valueInterface();
        QVERIFY(value);
        QCOMPARE(value->maximumValue().toULongLong(), qulonglong(stage.playhead.end()));

        value->setCurrentValue(77);

        QCOMPARE(stage.playhead.position(), std::size_t(77));
        stage.playhead.seek(5);
        QCOMPARE(value->currentValue().toULongLong(), 5ULL);
        QCOMPARE(accessible->text(QAccessible::Description),
                 stepText(*stage.playhead.traced(), stage.playhead.position()));
    }
};

PIXELPLUMB_TEST(TestScrubber)

} // namespace tst_scrubber

#include "tst_scrubber.moc"
