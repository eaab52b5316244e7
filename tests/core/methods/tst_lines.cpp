// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracereplay.h"

#include <QRandomGenerator>
#include <QTest>

#include <utility>

namespace tst_lines {

using namespace pixelplumb;

namespace {

Shape reversed(Shape line)
{
    std::swap(line.vertices[0], line.vertices[1]);
    return line;
}

/// Calls a function for lines between all points of a lattice of 12 × 12, in units of a third of
/// the frame's pixel or whole pixels.
template <class Function>
void forEachSmallLine(Lattice step, const Function &function)
{
    for (Lattice x0 = 0; x0 < 12; ++x0) {
        for (Lattice y0 = 0; y0 < 12; ++y0) {
            for (Lattice x1 = 0; x1 < 12; ++x1) {
                for (Lattice y1 = 0; y1 < 12; ++y1)
                    function(lineAtUnits({x0 * step, y0 * step}, {x1 * step, y1 * step}));
            }
        }
    }
}

Shape randomLine(QRandomGenerator &random, Lattice reach)
{
    const auto coordinate
        = [&] { return Lattice(random.bounded(qint64(-reach), qint64(reach + 1))); };
    const LatticePoint a = {coordinate(), coordinate()};
    return lineAtUnits(a, {coordinate(), coordinate()});
}

} // namespace

/// Lines against the truth: everywhere, in a window, traced.
class TestLines : public QObject {
    Q_OBJECT

private slots:
    void stableMethodsAreTheTruthOnEverySmallLine_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<qint64>("step");
        for (const char *method : {"line-dda", "line-bresenham-symmetric"}) {
            QTest::addRow("%s, whole pixels", method) << method << qint64(unitsPerPixel);
            QTest::addRow("%s, between pixels", method) << method << qint64(85);
        }
    }
    void stableMethodsAreTheTruthOnEverySmallLine()
    {
        QFETCH(QString, method);
        QFETCH(qint64, step);
        const FrameSpec frame = frameOf(14, 14, -1, -1);
        QString failure;
        forEachSmallLine(step, [&](const Shape &line) {
            if (!failure.isEmpty())
                return;
            const QString departed
                = departure(pictureBy(method, line, frame), truthOf(line, frame));
            if (!departed.isEmpty())
                failure = nameOf(line) + u": "_s + departed;
        });
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
    }

    void stableMethodsAreTheTruthOnLongLines_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<qint64>("reach");
        for (const char *method : {"line-dda", "line-bresenham-symmetric"}) {
            QTest::addRow("%s, 300 px", method) << method << qint64(300 * unitsPerPixel);
            QTest::addRow("%s, 2^30 px", method) << method << qint64(largestCoordinate);
        }
    }
    void stableMethodsAreTheTruthOnLongLines()
    {
        QFETCH(QString, method);
        QFETCH(qint64, reach);
        QRandomGenerator random(20);
        for (int round = 0; round < fewerIfSanitized(150); ++round) {
            const Shape line = randomLine(random, reach);
            // A window around the middle of a long line, which the line is sure to cross.
            const auto middle = [&](Lattice a, Lattice b) {
                return std::int32_t(floorPixel(a / 2 + b / 2) - 40);
            };
            const LatticePoint a = line.vertices[0].position;
            const LatticePoint b = line.vertices[1].position;
            const FrameSpec frame = frameOf(80, 80, middle(a.x, b.x), middle(a.y, b.y));
            const CasePicture truth = truthOf(line, frame);
            QVERIFY2(departure(pictureBy(method, line, frame), truth).isEmpty(),
                     qPrintable(u"seed 20, "_s + nameOf(line)));
            QVERIFY(truth.pixelCount() > 0);
        }
    }

    void aReversedLineHasTheSamePixels_data()
    {
        QTest::addColumn<QString>("method");
        QTest::newRow("Bresenham") << "line-bresenham";
        QTest::newRow("ties up") << "line-bresenham-symmetric";
    }
    void aReversedLineHasTheSamePixels()
    {
        QFETCH(QString, method);
        const auto faultOf = [&](const Shape &line, const FrameSpec &frame) {
            return textOf(pictureBy(method, line, frame))
                    == textOf(pictureBy(method, reversed(line), frame))
                ? QString()
                : nameOf(line);
        };
        QString fault;
        forEachSmallLine(unitsPerPixel, [&](const Shape &line) {
            if (fault.isEmpty())
                fault = faultOf(line, frameOf(12, 12));
        });
        QCOMPARE(fault, QString());
        QRandomGenerator random(20);
        for (int round = 0; round < fewerIfSanitized(250); ++round)
            QCOMPARE(faultOf(randomLine(random, 40 * unitsPerPixel), frameOf(81, 81, -40, -40)),
                     QString());
    }

    void bresenhamStoresTheLeftEndFirst()
    {
        // The shortest lines with a tie: y(1) = 1/2.
        QCOMPARE(textOf(pictureBy(u"line-bresenham", lineAt(2, 1, 0, 0), frameOf(3, 2))),
                 u".##\n#..\n"_s);
        QCOMPARE(textOf(pictureBy(u"line-bresenham", lineAt(2, 0, 0, 1), frameOf(3, 2))),
                 u"#..\n.##\n"_s);
        // A steep line from the end with the smaller y: x(1) = 1/2.
        QCOMPARE(textOf(pictureBy(u"line-bresenham", lineAt(1, 2, 0, 0), frameOf(2, 3))),
                 u".#\n.#\n#.\n"_s);
    }

    void bresenhamIsWrongAtTiesAlone()
    {
        const FrameSpec frame = frameOf(12, 12);
        QString failure;
        forEachSmallLine(unitsPerPixel, [&](const Shape &line) {
            const DifferenceCounts differences = differencesBetween(
                pictureBy(u"line-bresenham", line, frame), truthOf(line, frame));
            const LatticePoint a = line.vertices[0].position;
            const LatticePoint b = line.vertices[1].position;
            const Lattice length = std::max(absolute(b.x - a.x), absolute(b.y - a.y));
            const Lattice breadth = std::min(absolute(b.x - a.x), absolute(b.y - a.y));
            // y(k) = k·Δy/Δx ends in 1/2 for some k only if Δx has more factors of 2 than Δy.
            const bool mayTie = breadth != 0 && (length & -length) > (breadth & -breadth);
            if (differences.total() > 0 && !mayTie)
                failure = nameOf(line) + u": "_s + differences.message();
        });
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
    }

    void roundingArithmeticDriftsOnALongLine()
    {
        const Shape line = lineAt(0, 9001, 16381, 15013);
        const FrameSpec frame = frameOf(16382, 64, 0, 14960);
        const CasePicture truth = truthOf(line, frame);
        QVERIFY(departure(pictureBy(u"line-dda", line, frame), truth).isEmpty());
        QVERIFY(
            departure(pictureBy(u"line-dda", line, frame, Arithmetic::Fixed32), truth).isEmpty());
        QVERIFY(
            !departure(pictureBy(u"line-dda", line, frame, Arithmetic::Float32), truth).isEmpty());
    }

    void aWindowShowsWhatTheWholeFrameShows()
    {
        QRandomGenerator random(7);
        for (const Method &method : methods()) {
            const bool isOfLines = method.family == MethodFamily::Lines;
            for (int round = 0; isOfLines && round < fewerIfSanitized(60); ++round) {
                const Shape line = randomLine(random, 64 * unitsPerPixel);
                const CasePicture whole = pictureBy(method.id, line, frameOf(160, 160, -80, -80));
                const CasePicture window = pictureBy(method.id, line, frameOf(31, 17, -13, -5));
                for (std::int64_t y = -5; y < 12; ++y) {
                    for (std::int64_t x = -13; x < 18; ++x)
                        QVERIFY2(window.isWritten(x, y) == whole.isWritten(x, y),
                                 qPrintable(u"seed 7, "_s + method.id + nameOf(line)));
                }
            }
        }
    }

    // Drawing uses each line's own integer width, a trace the widest of all.
    void aLineBesideAVeryLongOneIsDrawnAsItIsTraced()
    {
        for (const char *method : {"line-dda", "line-slope-intercept"}) {
            Scene scene = sceneOf(lineAtUnits({515, 770}, {7700, 5401}), method, frameOf(40, 40));
            scene.shapes.push_back(
                lineAt(-largestPixel, -largestPixel + 3, largestPixel, largestPixel));
            const FrameBuffer drawn(scene.frame);
            drawScene(scene, drawn);

            const auto traced = traceScene(scene);

            QCOMPARE(replayed(*traced->trace, scene.frame), drawn.copy());
            QVERIFY(traced->trace->sampleCount() > 60);
        }
    }

    void stepsOfALongLineStayWithinTheFrame()
    {
        for (const char *method :
             {"line-dda", "line-slope-intercept", "line-bresenham", "line-bresenham-symmetric"}) {
            const auto traced = traceScene(
                sceneOf(lineAt(-largestPixel, -largestPixel + 3, largestPixel, largestPixel),
                        method, frameOf(16, 16)));
            QCOMPARE(traced->trace->spanCount(), std::size_t(16));
        }
    }
};

PIXELPLUMB_TEST(TestLines)

} // namespace tst_lines

#include "tst_lines.moc"
