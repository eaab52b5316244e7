// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layerpainter.h"
#include "core/polygons/textoutlines.h"
#include "tests/support/numbernamed.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tst_shapelayers {

using namespace pixelplumb;

namespace {

Shape polygonAt(const std::vector<QPoint> &corners)
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = ShapeFill::EvenOdd;
    for (const QPoint &corner : corners)
        polygon.vertices.push_back({latticePixel(corner.x(), corner.y()), Colour()});
    return polygon;
}

std::vector<LayerDrawing::Line> solidLinesOf(const LayerDrawing &drawing)
{
    std::vector<LayerDrawing::Line> solid;
    std::ranges::copy_if(
        drawing.lines, std::back_inserter(solid),
        [](const LayerDrawing::Line &line) { return line.stroke == LayerDrawing::Stroke::Solid; });
    return solid;
}

} // namespace

/// The layers of polygons, lines, circles and pixels, and how layers are painted.
class TestShapeLayers : public QObject {
    Q_OBJECT

private slots:
    void theBoxOfAPolygonIsThatOfItsVertices()
    {
        const Scene scene = sceneOf(polygonAt({{3, 2}, {9, 2}, {5, 11}}), "polygon-parity", {});

        const LayerDrawing drawing = Look(scene).drawing("box");

        QCOMPARE(textsOf(drawing.labels).first(), "bbox: x 3 … 9, y 2 … 11");
        QCOMPARE(drawing.lines.front().from, QPointF(3, 2));
    }

    void innerEdgesAreThoseThatTwoTrianglesShare()
    {
        const LayerDrawing fan
            = Look(sceneOf(polygonAt({{0, 0}, {8, 0}, {8, 6}, {2, 6}}), "polygon-fan", {}))
                  .drawing("inner-edges");

        const std::vector<LayerDrawing::Line> inner = solidLinesOf(fan);
        QCOMPARE(fan.lines.size(), std::size_t(5));
        QCOMPARE(inner.size(), std::size_t(1));
        QCOMPARE(inner.front().from, QPointF(0, 0));
        QCOMPARE(inner.front().to, QPointF(8, 6));
        QCOMPARE(fan.areas.size(), std::size_t(1)); // the current triangle
        QVERIFY(fan.circles.empty());
    }

    void circlesAroundDelaunayTrianglesHoldNoVertex()
    {
        const std::vector<QPoint> corners = {{0, 0}, {20, 2}, {30, 20}, {14, 28}, {1, 17}};
        const LayerDrawing drawing
            = Look(sceneOf(polygonAt(corners), "polygon-delaunay", {})).drawing("inner-edges");

        QCOMPARE(solidLinesOf(drawing).size(), std::size_t(2));
        QCOMPARE(drawing.circles.size(), std::size_t(3));
        for (const LayerDrawing::Circle &circle : drawing.circles) {
            int onCircle = 0;
            for (const QPoint &corner : corners) {
                const QPointF away = QPointF(corner) - circle.centre;
                const double beyond = std::hypot(away.x(), away.y()) - circle.radius;
                QVERIFY(beyond > -1e-9);
                onCircle += beyond < 1e-9 ? 1 : 0;
            }
            QCOMPARE(onCircle, 3);
        }
    }

    void theCurrentRowHasItsCrossingsAndIntervals()
    {
        // Two towers on a common base: a row through both has four crossings.
        Look look(sceneOf(polygonAt({{0, 0}, {20, 0}, {20, 10}, {10, 2}, {0, 10}}),
                          "polygon-parity", {}));
        const ScanTrace &trace = *look.traced->trace;
        const std::size_t span = *trace.spanOn(0, SpanAxis::Row, 6);
        look.view.position = trace.indexOfSpan(span) + 1;
        const LayerDrawing drawing = look.drawing("edge-table");

        std::vector<QPointF> crossings;
        std::vector<LayerDrawing::Line> intervals;
        for (const LayerDrawing::Point &point : drawing.points) {
            if (point.ink == LayerInk::Hand)
                crossings.push_back(point.place);
        }
        for (const LayerDrawing::Line &line : drawing.lines) {
            if (line.stroke == LayerDrawing::Stroke::Band)
                intervals.push_back(line);
        }
        // The slopes are ±5/4 px a row from (10, 2).
        QVERIFY(crossings == std::vector<QPointF>({{0, 6}, {5, 6}, {15, 6}, {20, 6}}));
        QCOMPARE(intervals.size(), std::size_t(2));
        QCOMPARE(intervals[0].from, QPointF(0, 6));
        QCOMPARE(intervals[0].to, QPointF(5, 6));
        QCOMPARE(intervals[1].from, QPointF(15, 6));
        QVERIFY(textsOf(drawing.labels).contains(u"edge 2, from row 3"_s));
    }

    void byWindingTheOverlapOfTwoContoursLiesInsideTwice()
    {
        Shape squares
            = polygonAt({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 0}, {12, 0}, {12, 8}, {4, 8}});
        squares.laterContours = {4};
        const auto intervalsOf = [&squares](ShapeFill fill) {
            squares.fill = fill;
            const Look look(sceneOf(squares, "polygon-parity", {}));
            const LayerDrawing drawing = look.drawing("edge-table");
            QStringList numbers;
            for (const LayerDrawing::Label &label : drawing.labels) {
                if (label.ink == LayerInk::Inside)
                    numbers.append(label.text);
            }
            const auto bands = std::ranges::count(drawing.lines, LayerDrawing::Stroke::Band,
                                                  &LayerDrawing::Line::stroke);
            return bands == numbers.size() ? numbers : QStringList();
        };

        // Between 0, 4, 8 and 12; both turn counter-clockwise.
        QCOMPARE(intervalsOf(ShapeFill::EvenOdd), QStringList({"p = 1", "p = 1"}));
        QCOMPARE(intervalsOf(ShapeFill::NonZero), QStringList({"w = 1", "w = 2", "w = 1"}));
    }

    void aLineAt45DegreesHasFewerPixelsForItsLength()
    {
        const auto textOf = [](const Shape &line, const char *method = "line-bresenham") {
            return textsOf(Look(sceneOf(line, method, {})).drawing("brightness").labels);
        };

        QCOMPARE(
            textOf(lineAt(4, 4, 24, 4)),
            QStringList({"(21 − 1) pixels / 20.00 px = 1.00 a px; even with 1.00 times the light",
                         "even: 1 px wide, 20.00 px of light"}));
        QCOMPARE(
            textOf(lineAt(4, 4, 24, 24)),
            QStringList({"(21 − 1) pixels / 28.28 px = 0.71 a px; even with 1.41 times the light",
                         "even: 1 px wide, 28.28 px of light"}));
        // End points between pixels: the first pixel is column 6, the last 8.
        Shape between = lineAt(5, 10, 9, 10);
        between.vertices[0].position.x += unitsPerPixel / 4;
        between.vertices[1].position.x -= unitsPerPixel / 4;
        QCOMPARE(textOf(between, "line-slope-intercept").front(),
                 u"(3 − 1) pixels / 2.00 px = 1.00 a px; even with 1.00 times the "
                 "light"_s);
    }

    void pixelsOfALineAreCountedAsTheyAreWritten()
    {
        Look look(sceneOf(lineAt(4, 4, 24, 4), "line-bresenham", {}));
        QStringList counts;
        for (look.view.position = 0; look.view.position < 4; ++look.view.position)
            counts += textsOf(look.drawing("brightness").labels);
        // The set-up, the first step and its pixel; the second step.
        QCOMPARE(counts,
                 QStringList(
                     {"0 pixels so far", "0 pixels so far", "0 pixels so far", "1 pixel so far"}));
    }

    void theLineStandsBetweenThePixelsOfADecision_data()
    {
        QTest::addColumn<Shape>("line");
        QTest::newRow("the slides' example") << lineAt(20, 41, 30, 44);
        QTest::newRow("falling") << lineAt(20, 41, 30, 38);
        QTest::newRow("steep") << lineAt(20, 10, 23, 20);
        QTest::newRow("steep and falling") << lineAt(20, 20, 17, 30);
        QTest::newRow("level") << lineAt(20, 20, 30, 20);
    }
    void theLineStandsBetweenThePixelsOfADecision()
    {
        QFETCH(Shape, line);
        Look look(sceneOf(line, "line-bresenham", {}));
        const ScanTrace &trace = *look.traced->trace;
        const QPointF start = placeOf(line.vertices[0].position);
        const QPointF run = placeOf(line.vertices[1].position) - start;

        look.view.position = trace.indexOfSpan(0) + 1;
        QVERIFY(look.drawing("decisions").isEmpty()); // no decision led to the first pixel
        for (std::size_t span = 1; span < trace.spanCount(); ++span) {
            look.view.position = trace.indexOfSpan(span) + 1;
            const LayerDrawing drawing = look.drawing("decisions");
            QCOMPARE(drawing.points.size(), std::size_t(3));
            const QPointF stays = drawing.points[0].place;
            const QPointF across = drawing.points[1].place;
            const QPointF onLine = drawing.points[2].place;
            const QPointF fromStart = onLine - start;
            QVERIFY(std::abs(fromStart.x() * run.y() - fromStart.y() * run.x()) < 1e-9);
            QCOMPARE((across - stays).manhattanLength(), 1.0);
            const PixelChange &pixel = trace.changes()[trace.firstSampleOf(span)];
            const QPointF drawn{double(pixel.x), double(pixel.y)};
            QVERIFY(drawn == stays || drawn == across);
            QVERIFY((drawn - onLine).manhattanLength() <= 0.5);
        }
    }

    void theLettersMarkTheirDistancesInEveryOctant_data()
    {
        QTest::addColumn<QPoint>("run");
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<QString>("stays"); ///< which of the two pixels, as seen on the screen
        QTest::addColumn<QString>("across");
        const auto upward = FrameOrigin::BottomLeft;
        const auto downward = FrameOrigin::TopLeft;
        QTest::newRow("flat, rising") << QPoint(11, 4) << upward << "lower"
                                      << "upper";
        QTest::newRow("steep, rising") << QPoint(4, 11) << upward << "left"
                                       << "right";
        QTest::newRow("steep, to the left") << QPoint(-4, 11) << upward << "right"
                                            << "left";
        QTest::newRow("flat, falling, given from the right") << QPoint(-11, 4) << upward << "upper"
                                                             << "lower";
        QTest::newRow("flat, rising, given from the right") << QPoint(-11, -4) << upward << "lower"
                                                            << "upper";
        QTest::newRow("steep, rising, given from above") << QPoint(-4, -11) << upward << "left"
                                                         << "right";
        QTest::newRow("steep, to the left, given from above") << QPoint(4, -11) << upward << "right"
                                                              << "left";
        QTest::newRow("flat, falling") << QPoint(11, -4) << upward << "upper"
                                       << "lower";
        QTest::newRow("flat, y downward") << QPoint(11, 4) << downward << "upper"
                                          << "lower";
        QTest::newRow("flat, rising as seen, y downward") << QPoint(11, -4) << downward << "lower"
                                                          << "upper";
        QTest::newRow("steep, y downward") << QPoint(4, 11) << downward << "left"
                                           << "right";
    }
    void theLettersMarkTheirDistancesInEveryOctant()
    {
        QFETCH(QPoint, run);
        QFETCH(FrameOrigin, origin);
        QFETCH(QString, stays);
        QFETCH(QString, across);
        FrameSpec frame;
        frame.origin = origin;
        Look look(sceneOf(lineAt(30, 20, 30 + run.x(), 20 + run.y()), "line-bresenham", frame));
        const ScanTrace &trace = *look.traced->trace;
        const QString note = u"“lower” is the distance to the pixel that stays, here the %1 one, "
                             "“upper” that to the %2 one"_s.arg(stays, across);
        for (std::size_t span = 1; span < trace.spanCount(); ++span) {
            look.view.position = trace.indexOfSpan(span) + 1;
            const LayerDrawing drawing = look.drawing("decisions");
            const QPointF onLine = drawing.points[2].place;
            const PixelChange before = trace.changes()[trace.firstSampleOf(span - 1)];
            const PixelChange after = trace.changes()[trace.firstSampleOf(span)];
            // The pixel that stays is on the line's other side from the previous one.
            const bool isSteep = std::abs(run.y()) > std::abs(run.x());
            const QPointF staying
                = isSteep ? QPointF(before.x, after.y) : QPointF(after.x, before.y);
            QCOMPARE(drawing.points[0].place, staying);

            // From the pixel that stays to the line, and from there to the pixel across: negative
            // where the line is not between them.
            const QPointF onward = drawing.points[1].place - staying;
            QCOMPARE(onward.manhattanLength(), 1.0);
            QCOMPARE(drawing.measures.size(), std::size_t(2));
            QCOMPARE(drawing.measures[0].from, staying);
            QCOMPARE(drawing.measures[1].to, drawing.points[1].place);
            const std::array names = {u"d_lower"_s, u"d_upper"_s};
            for (std::size_t i = 0; i < 2; ++i) {
                const Quantity number = spanNumber(*look.traced, span, names[i]);
                const LayerDrawing::Measure &measure = drawing.measures[i];
                const QPointF way = measure.to - measure.from;
                QVERIFY(std::abs(QPointF::dotProduct(way, onward) - number.toDouble()) < 1e-9);
                QVERIFY(measure.from == onLine || measure.to == onLine);
                QCOMPARE(measure.text, u"%1 = %2"_s.arg(names[i], cellNumber(number)));
            }
            QCOMPARE(drawing.notes.isEmpty(), stays == u"lower"_s);
            QVERIFY(drawing.notes.isEmpty() || drawing.notes.front().endsWith(note));
        }
    }

    void theMidpointThatDecidedAStepOfACircleHasItsF()
    {
        Look look(sceneOf(circleAt(32, 24, 10), "circle-midpoint", {}));
        const ScanTrace &trace = *look.traced->trace;
        look.view.position = trace.indexOfSpan(0) + 1;
        QVERIFY(look.drawing("decisions").isEmpty()); // no decision led to the first pixel
        for (std::size_t span = 1; span < trace.spanCount(); ++span) {
            look.view.position = trace.indexOfSpan(span) + 1;
            const LayerDrawing drawing = look.drawing("decisions");
            const QPointF midpoint = drawing.points.back().place - QPointF(32, 24);
            const double f = QPointF::dotProduct(midpoint, midpoint) - 100;
            QCOMPARE(drawing.labels.front().text,
                     u"F = p_k = %1"_s.arg(toDecimal(Quantity::of(f), std::abs(f) < 10 ? 2 : 1))
                         .replace(u'-', QChar(0x2212)));
            // The step's words and pixel belong to the same decision.
            QCOMPARE(spanNumber(*look.traced, span, u"p_k"_s).toDouble(), f);
            const QPointF drawn(32 + spanNumber(*look.traced, span, u"x_k"_s).toDouble(),
                                24 + spanNumber(*look.traced, span, u"y_k"_s).toDouble());
            QCOMPARE(drawn, drawing.points[f > 0 ? 2 : 1].place);
        }
    }

    void theDecisionOfAMidpointIsAWholeNumberOfQuarters_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::newRow("circle") << circleAt(32, 24, 10);
        QTest::newRow("ellipse") << ellipseAtUnits(latticePixel(32, 24), 13 * unitsPerPixel,
                                                   9 * unitsPerPixel);
    }
    void theDecisionOfAMidpointIsAWholeNumberOfQuarters()
    {
        QFETCH(Shape, shape);
        const Look look(sceneOf(shape, "circle-midpoint", {}));
        QVERIFY(
            look.traced->method->summary.contains("F at midpoints, a whole number of quarters"));
        bool isWhole = true;
        QVERIFY(look.traced->trace->spanCount() > 5);
        for (std::size_t span = 0; span < look.traced->trace->spanCount(); ++span) {
            const double next = spanNumber(*look.traced, span, u"p_next"_s).toDouble();
            QCOMPARE(4 * next, std::round(4 * next));
            isWhole = isWhole && next == std::round(next);
        }
        QVERIFY(!isWhole); // it is not an integer, as the table shows
    }

    void addressesAreThoseThatPointsAreWrittenBy()
    {
        FrameSpec frame;
        frame.width = 7;
        frame.height = 5;
        frame.firstColumn = -2;
        frame.firstRow = 3;
        Shape points;
        points.kind = PrimitiveKind::Point;
        points.vertices = {{latticePixel(1, 5), Colour()}};
        const Look look(sceneOf(points, "point-address", frame));

        const Quantity address = spanNumber(*look.traced, 0, u"addr"_s);

        QCOMPARE(textsIn(look.drawing("memory"), 1, 5), QStringList(toText(address)));
    }

    void samplesArePaintedInTheMiddleOfTheirCells_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<QPoint>("place");
        QTest::newRow("y upward") << FrameOrigin::BottomLeft << QPoint(70, 90);
        QTest::newRow("y downward") << FrameOrigin::TopLeft << QPoint(70, 10);
    }
    void samplesArePaintedInTheMiddleOfTheirCells()
    {
        QFETCH(FrameOrigin, origin);
        QFETCH(QPoint, place);
        FrameSpec frame;
        frame.width = 8;
        frame.height = 5;
        frame.firstColumn = -2;
        frame.firstRow = 7;
        frame.origin = origin;
        QImage picture(8 * 20, 5 * 20, QImage::Format_RGB32);
        picture.fill(Qt::white);
        LayerDrawing drawing;
        drawing.points = {{{1, 7}, LayerInk::First}};

        QPainter painter(&picture);
        LayerPainter().paint(painter, drawing,
                             {pictureTransform(frame, {}, 20), picture.rect(), LayerTone::Light});
        painter.end();

        QCOMPARE(picture.pixelColor(place), colourOf(LayerInk::First, LayerTone::Light));
        QCOMPARE(picture.pixelColor(place - QPoint(20, 0)), QColor(Qt::white));
    }

    void namesOfWhatIsFarOutOfViewAreNotWritten()
    {
        const QRectF view(0, 0, 200, 100);
        const auto isWritten = [&view](const QPointF &place) {
            QImage picture(200, 100, QImage::Format_RGB32);
            picture.fill(Qt::black);
            const QImage before = picture;
            LayerDrawing drawing;
            drawing.labels = {{u"E₀ > 0"_s, place, LayerInk::Mark}};
            QPainter painter(&picture);
            LayerPainter().paint(painter, drawing, {QTransform(), view, LayerTone::Light});
            painter.end();
            return picture != before;
        };

        QVERIFY(isWritten({100, 50}));
        QVERIFY(isWritten({205, 50})); // moved into view
        QVERIFY(!isWritten({300, 50}));
        QVERIFY(!isWritten({100, -90}));
    }

    void numbersAreWrittenInTheirCellsAndInNoOthers()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
        FrameSpec frame;
        frame.width = 3;
        frame.height = 1;
        QImage picture(3 * 40, 40, QImage::Format_RGB32);
        picture.fill(Qt::black);
        LayerDrawing drawing;
        drawing.cells = {{1, 0, u"0.25"_s}, {1, 0, u"−123"_s}};

        QPainter painter(&picture);
        LayerPainter().paint(painter, drawing,
                             {pictureTransform(frame, {}, 40), picture.rect(), LayerTone::Light});
        painter.end();

        const auto isBlack = [&](int left) {
            const QImage cell = picture.copy(left, 0, 40, 40);
            QImage black = cell;
            black.fill(Qt::black);
            return cell == black;
        };
        QVERIFY(isBlack(0));
        QVERIFY(!isBlack(40));
        QVERIFY(isBlack(80));
    }
};

PIXELPLUMB_TEST(TestShapeLayers)

} // namespace tst_shapelayers

#include "tst_shapelayers.moc"
