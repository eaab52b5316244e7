// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"

#include <QtTest>

namespace tst_playhead {

using namespace pixelplumb;

namespace {

constexpr auto forward = StepDirection::Forward;
constexpr auto backward = StepDirection::Backward;

/// A small triangle, one without area that the rule refuses, and one that overdraws the first.
std::shared_ptr<const TracedScene> traced(FillRule rule = FillRule::HalfOpenColumn)
{
    Scene scene;
    scene.frame.width = 24;
    scene.frame.height = 16;
    scene.settings.fillRule = rule;
    scene.triangles = {triangleAt(1, 1, 9, 3, 4, 10), triangleAt(5, 5, 9, 9, 7, 7),
                       triangleAt(3, 2, 14, 2, 8, 9)};
    return traceScene(scene);
}

QImage pictureOf(const Playhead &playhead) { return playhead.frame()->copy(); }

} // namespace

/// One object controls the position of all views.
class TestPlayhead : public QObject {
    Q_OBJECT

private slots:
    void stepsForwardAndBackwardUndoEachOtherAtEveryPosition_data() { addUnitRows(); }
    void stepsForwardAndBackwardUndoEachOtherAtEveryPosition()
    {
        QFETCH(StepUnit, unit);
        TracedPlayhead playhead(traced());
        std::vector<std::size_t> wrong;
        for (std::size_t position = 0; position <= playhead.end(); ++position) {
            playhead.seek(position);
            if (position < playhead.end()) {
                playhead.step(unit, forward);
                playhead.step(unit, backward);
                if (playhead.position() != position)
                    wrong.push_back(position);
            }
            playhead.seek(position);
            if (position > 0) {
                playhead.step(unit, backward);
                playhead.step(unit, forward);
                if (playhead.position() != position)
                    wrong.push_back(position);
            }
        }

        QCOMPARE(wrong, std::vector<std::size_t>());
    }

    void aWalkAllTheWayAndBackPassesTheSameStops_data() { addUnitRows(); }
    void aWalkAllTheWayAndBackPassesTheSameStops()
    {
        QFETCH(StepUnit, unit);
        TracedPlayhead playhead(traced());
        std::vector<std::size_t> stops{0};
        while (playhead.position() < playhead.end()) {
            playhead.step(unit, forward);
            stops.push_back(playhead.position());
        }
        std::vector<std::size_t> stopsBack{playhead.position()};
        while (playhead.position() > 0) {
            playhead.step(unit, backward);
            stopsBack.insert(stopsBack.begin(), playhead.position());
        }

        QCOMPARE(stopsBack, stops);
        QVERIFY(stops.size() > 3);
    }

    void columnStepsStopJustAfterEachSetUpAndEachColumnWasEntered()
    {
        TracedPlayhead playhead(traced());
        const ScanTrace &trace = *playhead.traced()->trace;
        std::vector<std::size_t> expected;
        for (std::size_t column = 0; column < trace.spanCount(); ++column)
            expected.push_back(trace.indexOfSpan(column) + 1);
        for (std::size_t triangle = 0; triangle < trace.primitiveCount(); ++triangle)
            expected.push_back(trace.indexOfSetUp(triangle) + 1); // one has no column to stop at
        expected.push_back(trace.stepCount());
        std::ranges::sort(expected);

        std::vector<std::size_t> stops;
        while (playhead.position() < playhead.end()) {
            playhead.step(StepUnit::Span, forward);
            stops.push_back(playhead.position());
        }

        QCOMPARE(stops, expected);
    }

    void theFrameStandsAsItStoodAtTheStep()
    {
        TracedPlayhead playhead(traced());
        std::vector<QImage> pictures;
        for (std::size_t position = 0; position <= playhead.end(); ++position) {
            playhead.seek(position);
            pictures.push_back(pictureOf(playhead));
        }
        for (std::size_t position = playhead.end() + 1; position-- > 0;) {
            playhead.seek(position);
            QVERIFY(pictureOf(playhead) == pictures[position]);
        }
        QVERIFY(pictures.front() != pictures.back());
    }

    void tellsOfAMoveExactlyOnce()
    {
        TracedPlayhead playhead(traced());
        const QSignalSpy moves(&playhead, &Playhead::positionChanged);

        playhead.step(StepUnit::Span, forward);
        playhead.seek(playhead.position());
        playhead.run(forward);
        playhead.seek(playhead.end() + 100);

        QCOMPARE(moves.size(), 2);
        QCOMPARE(playhead.position(), playhead.end());
    }

    void aStepPicksItsPixelAndAPickDoesNotMoveTime()
    {
        TracedPlayhead playhead(traced());
        while (!playhead.currentPixel())
            playhead.step(StepUnit::Sample, forward);
        QCOMPARE(playhead.pickedPixel(), playhead.currentPixel());
        const std::size_t position = playhead.position();

        playhead.pick({1000, -5});

        QCOMPARE(playhead.pickedPixel(), std::optional(QPoint(23, 0)));
        QCOMPARE(playhead.position(), position);
    }

    void runsToTheNextBreakpointInEitherDirection()
    {
        TracedPlayhead playhead(traced());
        playhead.toggleSpanBreakpoint({SpanAxis::Column, 6, 0});
        playhead.togglePixelBreakpoint({4, 5});
        std::vector<std::size_t> stops;
        do {
            playhead.run(forward);
            stops.push_back(playhead.position());
        } while (playhead.position() < playhead.end());
        std::vector<std::size_t> stopsBack;
        do {
            stopsBack.insert(stopsBack.begin(), playhead.position());
            playhead.run(backward);
        } while (playhead.position() > 0);

        // (4, 5) in the first triangle, column 6 in the first; the third covers x 3 … 13, at x = 4
        // only rows 2 and 3; then its column 6; then the end.
        QCOMPARE(stops.size(), std::size_t(4));
        QCOMPARE(stopsBack, stops);
        playhead.seek(stops[0]);
        QCOMPARE(playhead.currentPixel(), std::optional(QPoint(4, 5)));
        playhead.seek(stops[1]);
        QCOMPARE(playhead.currentColumnX(), std::optional<std::int64_t>(6));
        QVERIFY(!playhead.currentPixel());
    }

    void runsToTheStepsThatWriteThePickedPixel()
    {
        TracedPlayhead playhead(traced());
        playhead.pick({5, 3}); // in the first and the third triangle
        playhead.runToPickedPixel(forward);
        const std::size_t first = playhead.position();
        playhead.runToPickedPixel(forward);
        const std::size_t second = playhead.position();
        QSignalSpy messages(&playhead, &Playhead::message);
        playhead.runToPickedPixel(forward);

        QVERIFY(first < second);
        QCOMPARE(playhead.position(), second);
        QCOMPARE(messages.size(), 1);
        playhead.runToPickedPixel(backward);
        QCOMPARE(playhead.position(), first);
        QCOMPARE(playhead.currentStep()->primitive, std::size_t(0));
    }

    void keepsColumnAndPixelWhenASceneIsTracedAnew()
    {
        TracedPlayhead playhead(traced(FillRule::HalfOpenColumn));
        playhead.pick({5, 3});
        playhead.runToPickedPixel(forward);

        playhead.setTraced(traced(FillRule::Closed));

        QCOMPARE(playhead.currentPixel(), std::optional(QPoint(5, 3)));
        QCOMPARE(playhead.currentStep()->primitive, std::size_t(0));
    }

    void anAddedTriangleIsShownFinished()
    {
        TracedPlayhead playhead(traced());
        playhead.seek(3);
        Scene scene = playhead.traced()->scene;
        scene.triangles.push_back(triangleAt(15, 1, 20, 1, 18, 12));

        playhead.setTraced(traceScene(scene));

        QCOMPARE(playhead.position(), playhead.end());
    }

    void playingStopsAtABreakpointAndAtTheEnd()
    {
        TracedPlayhead playhead(traced());
        playhead.toggleSpanBreakpoint({SpanAxis::Column, 6, 0});
        playhead.setStepsPerSecond(Playhead::fastest);
        playhead.setPlaying(true);
        QTRY_VERIFY(!playhead.isPlaying());
        QCOMPARE(playhead.currentColumnX(), std::optional<std::int64_t>(6));

        playhead.clearBreakpoints();
        playhead.setPlaying(true);
        QTRY_VERIFY(!playhead.isPlaying());
        QCOMPARE(playhead.position(), playhead.end());
    }

    void standsStillWithoutARun()
    {
        Playhead playhead;
        playhead.step(StepUnit::Span, forward);
        playhead.run(backward);
        playhead.runToPickedPixel(forward);
        playhead.nudgePick(1, 1);
        playhead.setPlaying(true);
        playhead.seekToSpan(3);

        QCOMPARE(playhead.position(), std::size_t(0));
        QVERIFY(!playhead.isPlaying());
        QVERIFY(!playhead.frame());
    }

private:
    static void addUnitRows()
    {
        QTest::addColumn<StepUnit>("unit");
        QTest::newRow("set-up") << StepUnit::SetUp;
        QTest::newRow("column") << StepUnit::Span;
        QTest::newRow("pixel") << StepUnit::Sample;
    }
};

PIXELPLUMB_TEST(TestPlayhead)

} // namespace tst_playhead

#include "tst_playhead.moc"
