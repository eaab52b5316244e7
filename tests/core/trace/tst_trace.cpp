// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/formulaexplanation.h"
#include "core/runs/pixelhistory.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <map>
#include <random>

namespace tst_trace {

using namespace pixelplumb;

namespace {

Scene sceneOf(std::vector<Triangle> triangles, const ScanSettings &settings = {})
{
    Scene scene;
    scene.settings = settings;
    scene.triangles = std::move(triangles);
    return scene;
}

Scene threeTriangles(const ScanSettings &settings = {})
{
    return sceneOf({triangleAtUnits({1024, 1280}, {14848, 3072}, {6784, 11264}),
                    triangleAt(-9, 3, 70, 40, 20, 60), triangleAt(5, 5, 9, 9, 7, 7),
                    triangleAt(30, 2, 30, 46, 61, 20)},
                   settings);
}

QImage drawnPicture(const Scene &scene)
{
    FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return frame.copy();
}

void addSettingsRows()
{
    QTest::addColumn<ScanSettings>("settings");
    for (const Arithmetic arithmetic : allArithmetics) {
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
            const std::string name
                = std::string(nameOf(arithmetic)) + ", " + std::string(nameOf(rule));
            QTest::newRow(name.c_str()) << ScanSettings{arithmetic, rule, ByteRounding::Nearest};
        }
    }
}

} // namespace

/// Drawing and explaining are the same code: the trace's promises.
class TestTrace : public QObject {
    Q_OBJECT

private slots:
    void tracingDoesNotChangeTheFrame_data() { addSettingsRows(); }
    void tracingDoesNotChangeTheFrame()
    {
        QFETCH(ScanSettings, settings);
        const Scene scene = threeTriangles(settings);
        FrameBuffer traced(scene.frame);
        const auto trace
            = columnScan().trace(primitivesOnSamples(scene), settings, traced.view(), {});
        QCOMPARE(traced.copy(), drawnPicture(scene));
        QVERIFY(trace->sampleCount() > 500);
    }

    void replayToTheEndGivesTheFrame_data() { addSettingsRows(); }
    void replayToTheEndGivesTheFrame()
    {
        QFETCH(ScanSettings, settings);
        const auto traced = traceScene(threeTriangles(settings));
        TraceCursor cursor(*traced->trace, traced->scene.frame);
        cursor.seek(traced->trace->stepCount());
        QCOMPARE(cursor.frame().copy(), drawnPicture(traced->scene));
    }

    void seekingThereAndBackGivesTheStart_data() { addSettingsRows(); }
    void seekingThereAndBackGivesTheStart()
    {
        QFETCH(ScanSettings, settings);
        const auto traced = traceScene(threeTriangles(settings));
        const QImage start = FrameBuffer(traced->scene.frame).copy();
        TraceCursor cursor(*traced->trace, traced->scene.frame);
        for (std::size_t k = 0; k <= traced->trace->stepCount(); k += 97) {
            cursor.seek(k);
            cursor.seek(0);
            QCOMPARE(cursor.frame().copy(), start);
        }
    }

    void aSeekFromAnywhereGivesTheSameFrame()
    {
        const auto traced = traceScene(threeTriangles());
        std::mt19937 random(20);
        TraceCursor wanderer(*traced->trace, traced->scene.frame);
        for (int i = 0; i < 40; ++i) {
            const std::size_t k = random() % (traced->trace->stepCount() + 1);
            wanderer.seek(k);
            TraceCursor direct(*traced->trace, traced->scene.frame);
            direct.seek(k);
            QCOMPARE(wanderer.frame().copy(), direct.frame().copy());
        }
    }

    void indicesOfStepsAndTheirKindsAreInverse()
    {
        const auto traced = traceScene(threeTriangles());
        const ScanTrace &trace = *traced->trace;
        std::size_t pixels = 0;
        for (std::size_t index = 0; index < trace.stepCount(); ++index) {
            QCOMPARE(trace.samplesDoneAt(index), pixels);
            const TraceStep step = trace.stepAt(index);
            switch (step.kind) {
            case StepKind::SetUp:
                QCOMPARE(trace.indexOfSetUp(step.primitive), index);
                break;
            case StepKind::Span:
                QCOMPARE(trace.indexOfSpan(step.span), index);
                QCOMPARE(trace.primitiveOf(step.span), step.primitive);
                break;
            case StepKind::Sample:
                QCOMPARE(trace.indexOfSample(step.sample), index);
                QCOMPARE(trace.spanOf(step.sample), step.span);
                QCOMPARE(step.sample, pixels);
                ++pixels;
                break;
            }
        }
        QCOMPARE(pixels, trace.sampleCount());
    }

    void fragmentsAreTheNumbersThatWroteTheBytes_data() { addSettingsRows(); }
    void fragmentsAreTheNumbersThatWroteTheBytes()
    {
        QFETCH(ScanSettings, settings);
        const auto traced = traceScene(threeTriangles(settings));
        const ScanTrace &trace = *traced->trace;
        for (std::size_t column = 0; column < trace.spanCount(); ++column) {
            const std::vector<SampleRecord> fragments = trace.samples(column);
            QCOMPARE(fragments.size(), trace.endSampleOf(column) - trace.firstSampleOf(column));
            for (std::size_t i = 0; i < fragments.size(); ++i) {
                const PixelChange &change = trace.changes()[trace.firstSampleOf(column) + i];
                QCOMPARE(fragments[i].y, std::int64_t(change.y));
                QCOMPARE(std::clamp<std::int64_t>(fragments[i].level[0], 0, 255),
                         std::int64_t(qRed(change.after)));
                QCOMPARE(std::clamp<std::int64_t>(fragments[i].level[2], 0, 255),
                         std::int64_t(qBlue(change.after)));
            }
        }
    }

    void exactArithmeticNeverDiffersFromTheTruth()
    {
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
            const auto traced
                = traceScene(threeTriangles({Arithmetic::Exact, rule, ByteRounding::Nearest}));
            QCOMPARE(traced->differences.total(), std::int64_t(0));
            QVERIFY(std::ranges::none_of(traced->marks, [](const TraceMark &mark) {
                return mark.kind == MarkKind::FirstDifference;
            }));
        }
    }

    void theFirstDifferenceIsMarkedWhereItAppears()
    {
        // -11/31 added 31 times and -3/28 added 28 times in float32 both miss the integer at the
        // last vertex, on the same side.
        const Scene scene = sceneOf({triangleAt(6, 44, 9, 36, 37, 33)},
                                    {Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest});
        const auto traced = traceScene(scene);
        QCOMPARE(traced->differences.total(), std::int64_t(1));
        const auto mark
            = std::ranges::find(traced->marks, MarkKind::FirstDifference, &TraceMark::kind);
        QVERIFY(mark != traced->marks.end());
        const TraceStep step = traced->trace->stepAt(mark->step);
        QCOMPARE(traced->trace->placeOf(step.span).coordinate, std::int64_t(37));
        QCOMPARE(traced->differences.at(37, 33), Difference::Missing);
    }

    void aWrongPixelIsDecidedByItsLastVisit_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *method : {"column-scan", "row-walk", "barycentric-incremental"}) {
            for (const Arithmetic arithmetic : {Arithmetic::Float32, Arithmetic::Fixed16}) {
                if (methodNamed(QString::fromLatin1(method))->supports(arithmetic))
                    QTest::addRow("%s, %s", method, nameOf(arithmetic).data())
                        << QString::fromLatin1(method) << arithmetic;
            }
        }
    }
    void aWrongPixelIsDecidedByItsLastVisit()
    {
        QFETCH(const QString, method);
        QFETCH(const Arithmetic, arithmetic);
        Scene scene = threeTriangles({arithmetic, FillRule::Closed, ByteRounding::Nearest});
        scene.method = method.toStdString();
        scene.triangles.push_back(triangleAt(6, 44, 9, 36, 37, 33));
        const auto traced = traceScene(scene);
        const ScanTrace &trace = *traced->trace;
        QVERIFY(traced->differences.total() > 0);

        std::map<std::pair<int, int>, std::size_t> lastVisits; // positions
        for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
            const PixelChange &change = trace.changes()[sample];
            const Difference kind = traced->differences.at(change.x, change.y);
            if (kind == Difference::Missing || (kind != Difference::None && change.isWritten()))
                lastVisits[{change.x, change.y}] = trace.indexOfSample(sample) + 1;
        }
        std::size_t first = trace.stepCount() + 1;
        for (int y = 0; y < scene.frame.height; ++y) {
            for (int x = 0; x < scene.frame.width; ++x) {
                if (traced->differences.at(x, y) == Difference::None)
                    continue;
                first = std::min(first, traced->decidedAt(x, y));
                const auto visit = lastVisits.find({x, y});
                if (visit != lastVisits.end())
                    QCOMPARE(traced->decidedAt(x, y), visit->second);
                else
                    QVERIFY(traced->differences.at(x, y) == Difference::Missing);
            }
        }
        QCOMPARE(traced->firstWrongPixel()->decidedAt, first);
        const auto mark
            = std::ranges::find(traced->marks, MarkKind::FirstDifference, &TraceMark::kind);
        QCOMPARE(mark->step + 1, first);
    }

    void aRecordingAtItsLimitKeepsItsFirstStepsAndSaysSo()
    {
        TraceOptions options;
        options.sampleLimit = 100;
        const auto traced = traceScene(threeTriangles(), options);
        QVERIFY(traced->trace->isCut());
        QCOMPARE(traced->trace->sampleCount(), std::size_t(100));
        QCOMPARE(traced->differences.total(), std::int64_t(0));
        TraceCursor cursor(*traced->trace, traced->scene.frame);
        cursor.seek(traced->trace->stepCount());
        cursor.seek(0);
        QCOMPARE(cursor.frame().copy(), FrameBuffer(traced->scene.frame).copy());
    }

    void aCancelledRecordingGivesNothing()
    {
        TraceOptions options;
        options.progress = [](const JobProgress &progress) { return progress.done < 5; };
        QVERIFY(!traceScene(threeTriangles(), options));
    }

    void theHistoryOfAPixelTellsEveryTrianglesAttempt()
    {
        const auto traced = traceScene(threeTriangles());
        const std::vector<PixelAttempt> history = pixelHistory(*traced, 40, 20);
        QCOMPARE(history.size(), std::size_t(4));
        QVERIFY(history[0].written);
        QVERIFY(history[0].reason.startsWith(QStringLiteral("Writes R = ")));
        QVERIFY(!history[2].written);
        QVERIFY(history[2].reason.contains(QStringLiteral("no area")));
        QVERIFY(history[3].written);
        QCOMPARE(history[3].change.before,
                 history[1].written ? history[1].change.after : history[0].change.after);
        QCOMPARE(traced->trace->stepAt(history[3].step).kind, StepKind::Sample);
        const std::vector<PixelAttempt> outside = pixelHistory(*traced, 4, 6);
        QVERIFY(outside[0].reason.contains(QStringLiteral("Refused by L₀₁")));
        QVERIFY(outside[0].reason.contains(QStringLiteral("-1 px measured along the column")));
    }

    void halfPixelCentresShiftTheVerticesAndNothingElse()
    {
        Scene scene = sceneOf({triangleAt(4, 5, 58, 12, 26, 44)});
        scene.frame.pixelCentre = PixelCentre::Half;
        Scene shifted = sceneOf({triangleAtUnits({896, 1152}, {14720, 2944}, {6528, 11136})});
        QCOMPARE(drawnPicture(scene), drawnPicture(shifted));
    }

    void explainsEveryStepWithTheNumberThatItProduced()
    {
        const auto traced = traceScene(
            threeTriangles({Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest}));
        const ScanTrace &trace = *traced->trace;
        for (std::size_t index = 0; index < trace.stepCount(); ++index) {
            const Explanation explanation = explainStep(*traced, index);
            QVERIFY(!explanation.heading.isEmpty());
            QVERIFY(!explanation.sentence.isEmpty());
            const TraceStep step = trace.stepAt(index);
            if (step.kind == StepKind::Span)
                QCOMPARE(explanation.lines.front().used, trace.span(step.span).lower);
        }
    }
};

PIXELPLUMB_TEST(TestTrace)

} // namespace tst_trace

#include "tst_trace.moc"
