// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/testprogram.h"

#include <QSet>
#include <QTest>

namespace tst_rejections {

using namespace pixelplumb;

namespace {

/// Something of each kind, and of each kind something that one method or another rejects.
const char *const everything
    = "{ 'triangle': [[1, 1], [7, 2], [3, 7]], 'colors': ['#ff0000', '#00ff00', '#0000ff'] },\n"
      "{ 'triangle': [[1, 1], [3, 2], [5, 3]], 'colors': ['#ff0000', '#00ff00', '#0000ff'] },\n"
      "{ 'triangle': [[90, 1], [99, 2], [95, 9]], 'colors': ['#ff0000', '#00ff00', '#0000ff'] },\n"
      "{ 'triangle': [[-70000, 1], [70000, 2], [3, 70000]],"
      " 'colors': ['#ff0000', '#00ff00', '#0000ff'] },\n"
      "{ 'points': [[1, 2], [3, 4]], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'line': [[0, 0], [7, 5]], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'line': [[4, 1], [4, 6]], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'circle': { 'centre': [4, 4], 'radius': 3 }, 'color': '#cc7722', 'fill': 'outline' },\n"
      "{ 'bezier': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722' },\n"
      "{ 'polygon': [[1, 1], [6, 1], [6, 6]], 'color': '#cc7722' },\n"
      "{ 'polygon': [[1, 1], [6, 1], [3, 3], [6, 6], [1, 6]], 'color': '#cc7722' },\n"
      "{ 'polygon': [[1, 1], [6, 6], [6, 1], [1, 6]], 'color': '#cc7722' },\n"
      // without area, or so small that they lie between the samples
      "{ 'line': [[2, 2], [2, 2]], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'line': [['5/4', '5/4'], ['11/8', '11/8']], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'line': [['5/4', '3/2'], ['11/8', '3/2']], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'line': [[20, 2], [30, 2]], 'colors': ['#cc7722', '#ffffff'] },\n"
      "{ 'circle': { 'centre': ['9/2', '9/2'], 'radius': '1/8' }, 'color': '#cc7722',"
      " 'fill': 'outline' },\n"
      "{ 'circle': { 'centre': ['9/2', '9/2'], 'radius': '1/8' }, 'color': '#cc7722',"
      " 'fill': 'filled' },\n"
      "{ 'bezier': [[5, 5], [5, 5], [5, 5]], 'color': '#cc7722' },\n"
      "{ 'bezier': [['5/4', '5/4'], ['21/16', '11/8'], ['11/8', '11/8']], 'color': '#cc7722' },\n"
      "{ 'polygon': [['5/4', '5/4'], ['3/2', '5/4'], ['3/2', '3/2']], 'color': '#cc7722' },\n"
      "{ 'polygon': [[1, 1], [6, 1], [3, 1]], 'color': '#cc7722' },\n"
      "{ 'points': [[30, 2]], 'colors': ['#cc7722'] },\n"
      "{ 'text': 'i', 'at': ['5/4', '5/4'], 'height': '1/4', 'color': '#cc7722' }";

QByteArray sceneText() { return sceneOfPrimitives(json(everything)); }

} // namespace

/// Nobody gets a blank picture without a word.
class TestRejections : public QObject {
    Q_OBJECT

private slots:
    void areKnownWithoutARecording_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void areKnownWithoutARecording()
    {
        QFETCH(QString, method);
        const Result<SceneReading> reading = readScene(sceneText());
        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        Scene scene = reading->scene;
        const Method &drawnBy = *methodNamed(method);
        scene.method = method.toStdString();
        for (const Arithmetic arithmetic : drawnBy.arithmetics) {
            for (const FillRule rule : drawnBy.fillRules) {
                scene.settings.arithmetic = arithmetic;
                scene.settings.fillRule = rule;

                const auto traced = traceScene(scene);

                const auto recorded = rejectedPrimitives(*traced);
                QCOMPARE(rejectedPrimitives(SceneRun(scene)), recorded);
                // Nothing is hidden here: what is not told has written pixels, and only that.
                QSet<std::size_t> written;
                const ScanTrace &trace = *traced->trace;
                for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
                    if (trace.changes()[sample].isWritten())
                        written.insert(trace.primitiveOf(trace.spanOf(sample)));
                }
                QSet<std::size_t> rejected;
                for (const RejectedPrimitive &each : recorded)
                    rejected.insert(each.primitive);
                for (std::size_t i = 0; i < traced->primitives.size(); ++i) {
                    QVERIFY2(written.contains(i) != rejected.contains(i),
                             qPrintable(QString::number(i)));
                    QCOMPARE(rejectionOf(*traced, i).has_value(), rejected.contains(i));
                    QCOMPARE(setUpRow(*traced, i).rejection.has_value(), rejected.contains(i));
                }
            }
        }
    }

    /// Its bounding box has samples, and it none.
    void aTriangleBetweenTheSamplesIsTold_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QByteArray>("setting");
        const auto row = [](const char *method, const char *setting) {
            QTest::addRow("%s %s", method, setting)
                << QString::fromLatin1(method) << QByteArray(setting);
        };
        row("column-scan", "");
        row("row-walk", "");
        row("edge-equations", "");
        row("interpolate-plane", "");
        row("column-scan", "\"antialiasing\": 16,");
    }
    void aTriangleBetweenTheSamplesIsTold()
    {
        QFETCH(QString, method);
        QFETCH(QByteArray, setting);
        // From (1 1/8, 1 1/4) to (6 7/8, 6 5/8), a sixteenth of a pixel high.
        const QByteArray scene = sceneOfPrimitives(
            json("{ 'triangle': [['9/8', '5/4'], ['9/8', '21/16'], ['55/8', '53/8']],"
                 " 'colors': ['#ff0000', '#00ff00', '#0000ff'] }"),
            setting);
        const Result<SceneReading> reading = readScene(scene);
        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        Scene drawn = reading->scene;
        drawn.method = method.toStdString();
        const bool isDrawn = !setting.isEmpty(); // where pixels have more samples
        const auto traced = traceScene(drawn);
        QCOMPARE(traced->trace->writtenCount() > 0, isDrawn);
        QVERIFY(traced->trace->spanCount() > 0);
        const auto recorded = rejectedPrimitives(*traced);
        QCOMPARE(recorded.size(), std::size_t(isDrawn ? 0 : 1));
        QCOMPARE(rejectedPrimitives(SceneRun(drawn)), recorded);
        for (const RejectedPrimitive &each : recorded)
            QCOMPARE(
                each.message(),
                u"primitive 0 (triangle): It reaches into the frame, but by the run's tests no "
                "sample of the frame belongs to it. Nothing is drawn."_s);
    }

    /// Whether a part of it lies within the squares of the frame's pixels, 8 × 8 from (−½, −½) on.
    void whereItLiesIsToldOfWhatHasNoSampleOfTheFrame_data()
    {
        QTest::addColumn<QByteArray>("primitive");
        QTest::addColumn<bool>("reachesIn");
        const auto triangle = [](const char *vertices) {
            return json("{ 'triangle': " + QByteArray(vertices)
                        + ", 'colors': ['#ff0000', '#00ff00', '#0000ff'] }");
        };
        QTest::newRow("between four samples")
            << triangle("[['9/8', '9/8'], ['15/8', '5/4'], ['3/2', '15/8']]") << true;
        QTest::newRow("in the last half pixel")
            << triangle("[['57/8', 1], ['59/8', 1], ['59/8', 5]]") << true;
        QTest::newRow("beyond it") << triangle("[['61/8', 1], ['63/8', 1], ['63/8', 5]]") << false;
        // Its box has the frame's corner, and no sample; beyond x + y = 15 there is no frame.
        QTest::newRow("across the corner")
            << triangle("[['29/4', 8], [8, '29/4'], [8, 8]]") << false;
        QTest::newRow("far away") << triangle("[[40, 40], [50, 40], [50, 50]]") << false;
    }
    void whereItLiesIsToldOfWhatHasNoSampleOfTheFrame()
    {
        QFETCH(QByteArray, primitive);
        QFETCH(bool, reachesIn);
        const Result<SceneReading> reading = readScene(sceneOfPrimitives(primitive));
        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        for (const char *method : {"column-scan", "edge-equations", "barycentric-rectangle"}) {
            Scene scene = reading->scene;
            scene.method = method;
            const auto rejected = rejectedPrimitives(SceneRun(scene));
            QCOMPARE(rejected.size(), std::size_t(1));
            QVERIFY2(
                rejected[0].message().contains(reachesIn ? u"reaches into"_s : u"lies outside"_s),
                qPrintable(rejected[0].message()));
            QCOMPARE(rejectedPrimitives(*traceScene(scene)), rejected);
        }
    }

    /// By one function for the commands, the panels and the table.
    void aStrokeBetweenTheSamplesHasAReason()
    {
        const QByteArray scene
            = sceneOfPrimitives(json("{ 'line': [['5/4', '3/2'], ['11/8', '3/2']],"
                                     " 'colors': ['#ff0000', '#00ff00'] }"));
        Scene drawn = readScene(scene)->scene;
        drawn.method = "stroke-coverage";
        const auto traced = traceScene(drawn);
        QCOMPARE(traced->trace->writtenCount(), std::size_t(0));

        const QString told = u"It reaches into the frame, but by the run's tests no sample of the "
                             "frame belongs to it. Nothing is drawn."_s;
        QVERIFY(rejectedPrimitives(SceneRun(drawn)).at(0).message().endsWith(told));
        QVERIFY(explainStep(*traced, 0).sentence.endsWith(told));
        QCOMPARE(pixelHistory(*traced, 6, 6).at(0).reason, told);
        QVERIFY(pixelHistory(*traced, 1, 1).at(0).reason.startsWith(u"Refused"_s));
    }

    /// Behind another one it wrote nothing and covers samples.
    void aTriangleThatIsHiddenIsNotTold()
    {
        const QByteArray hidden
            = sceneOfPrimitives(json("{ 'triangle': [[0, 0], [6, 0], [0, 6]], 'z': [0, 0, 0],"
                                     " 'colors': ['#ff0000', '#ff0000', '#ff0000'] },"
                                     "{ 'triangle': [[1, 1], [3, 1], [1, 3]], 'z': [1, 1, 1],"
                                     " 'colors': ['#0000ff', '#0000ff', '#0000ff'] }"));
        const Scene scene = readScene(hidden)->scene;
        QVERIFY(rejectedPrimitives(*traceScene(scene)).empty());
        QVERIFY(rejectedPrimitives(SceneRun(scene)).empty());
    }
};

PIXELPLUMB_TEST(TestRejections)

} // namespace tst_rejections

#include "tst_rejections.moc"
