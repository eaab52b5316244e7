// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "widgets/look/appearance.h"
#include "widgets/look/framepainter.h"

#include <QTest>
#include <QtWidgets>

#include <cmath>

namespace tst_framepainter {

using namespace pixelplumb;

namespace {

constexpr QRectF view(0, 0, 700, 520);

/// A white canvas to draw on.
struct Sheet {
    explicit Sheet(const ViewMapping &at)
        : mapping(at)
        , picture(view.size().toSize(), QImage::Format_RGB32)
    {
        picture.fill(Qt::white);
        painter.begin(&picture);
    }

    /// Whether there is ink within a pixel of a sample point.
    bool hasInkAt(double x, double y) const
    {
        const QPoint at = mapping.positionOf(x, y).toPoint();
        for (const QPoint &beside : {QPoint(0, 0), QPoint(-1, -1), QPoint(-1, 0), QPoint(0, -1)}) {
            if (qGray(picture.pixel(at + beside)) < 128)
                return true;
        }
        return false;
    }

    /// Whether there is ink at a tenth of the points between two sample points, as along a dashed
    /// line.
    bool hasInkAlong(const QPointF &from, const QPointF &to) const
    {
        constexpr int looks = 200;
        int found = 0;
        for (int i = 0; i <= looks; ++i) {
            const QPointF place = from + (to - from) * i / looks;
            found += hasInkAt(place.x(), place.y()) ? 1 : 0;
        }
        return found > looks / 10;
    }

    ViewMapping mapping;
    QImage picture;
    QPainter painter;
    QPalette palette = lightPalette();
    FramePainter frame{painter, mapping, palette, view};
};

Shape polygonAt(const std::vector<LatticePoint> &corners)
{
    Shape shape;
    shape.kind = PrimitiveKind::Polygon;
    shape.fill = ShapeFill::EvenOdd;
    for (const LatticePoint &corner : corners)
        shape.vertices.push_back({corner, {}});
    return shape;
}

/// A filled path of quadratic pieces.
Shape pathAt(const std::vector<LatticePoint> &controls)
{
    Shape path = bezierAt(controls);
    path.fill = ShapeFill::EvenOdd;
    for (std::size_t next = 3; next < controls.size(); next += 3)
        path.laterContours.push_back(next);
    return path;
}

/// Random corners, including (5, 5) and (35, 25), that lie between these two.
std::vector<LatticePoint> randomCorners(int count)
{
    QRandomGenerator random(1);
    std::vector<LatticePoint> corners = {latticePixel(5, 5), latticePixel(35, 25)};
    while (int(corners.size()) < count)
        corners.push_back(latticePixel(5 + random.bounded(31), 5 + random.bounded(21)));
    return corners;
}

} // namespace

/// What is drawn over the frame: outlines and names.
class TestFramePainter : public QObject {
    Q_OBJECT

private slots:
    void everyShapeHasAnOutlineHoweverFlatItIs_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QPointF>("place"); ///< on its outline, away from its vertices
        const auto at = [](std::int64_t x, std::int64_t y) { return latticePixel(x, y); };
        QTest::newRow("level line") << lineAt(5, 9, 35, 9) << QPointF(20, 9);
        QTest::newRow("upright line") << lineAt(9, 5, 9, 25) << QPointF(9, 15);
        QTest::newRow("slanting line") << lineAt(5, 5, 25, 25) << QPointF(15, 15);
        QTest::newRow("line from far to far")
            << lineAt(-1'000'000, 9, 1'000'000, 9) << QPointF(20, 9);
        QTest::newRow("circle") << circleAt(20, 15, 9) << QPointF(20, 24);
        QTest::newRow("circle that is seen in part")
            << circleAt(-3980, 15, 4000) << QPointF(20, 15);
        QTest::newRow("ellipse without height")
            << ellipseAtUnits(at(20, 15), 9 * unitsPerPixel, 0) << QPointF(15, 15);
        QTest::newRow("ellipse without width")
            << ellipseAtUnits(at(20, 15), 0, 9 * unitsPerPixel) << QPointF(20, 11);
        QTest::newRow("level curve")
            << bezierAt({at(5, 9), at(20, 9), at(35, 9)}) << QPointF(12, 9);
        QTest::newRow("upright curve")
            << bezierAt({at(9, 5), at(9, 12), at(9, 18), at(9, 25)}) << QPointF(9, 10);
        QTest::newRow("second piece of a path")
            << pathAt({at(5, 5), at(10, 5), at(15, 5), at(15, 5), at(25, 25), at(35, 5)})
            << QPointF(25, 15);
        QTest::newRow("gap between the pieces of a path")
            << pathAt({at(5, 5), at(8, 5), at(10, 5), at(30, 20), at(33, 20), at(35, 20)})
            << QPointF(15, 8.75);
        QTest::newRow("polygon") << polygonAt({at(5, 5), at(35, 5), at(20, 25)}) << QPointF(20, 5);
        QTest::newRow("level polygon")
            << polygonAt({at(5, 9), at(35, 9), at(25, 9)}) << QPointF(15, 9);
        QTest::newRow("upright polygon")
            << polygonAt({at(9, 5), at(9, 25), at(9, 20)}) << QPointF(9, 10);
    }
    void everyShapeHasAnOutlineHoweverFlatItIs()
    {
        QFETCH(Shape, shape);
        QFETCH(QPointF, place);
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        sheet.frame.drawShapeOutline(shape);
        QVERIFY(sheet.hasInkAt(place.x(), place.y()));
    }

    /// An outline that would hide the picture, and take seconds to paint, is drawn as its bounds:
    /// the number of painted elements is bounded, whatever the shape.
    void aDenseOutlineIsDrawnAsItsBounds_data()
    {
        QTest::addColumn<int>("corners");
        QTest::addColumn<bool>("isCurved");
        QTest::newRow("30,000 corners") << 30'000 << false;
        QTest::newRow("100,000 corners") << 100'000 << false;
        QTest::newRow("10,000 control points") << 10'002 << true;
    }
    void aDenseOutlineIsDrawnAsItsBounds()
    {
        QFETCH(int, corners);
        QFETCH(bool, isCurved);
        Shape shape = isCurved ? pathAt(randomCorners(corners)) : polygonAt(randomCorners(corners));
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        QPicture record;
        QPainter recorder(&record);
        FramePainter(recorder, sheet.mapping, sheet.palette, view).drawShapeOutline(shape);
        recorder.end();

        QVERIFY2(record.size() < 4'000, qPrintable(QString::number(record.size()))); // bytes
        sheet.frame.drawShapeOutline(shape);
        QVERIFY(sheet.hasInkAlong({5, 5}, {35, 5}));
        QVERIFY(sheet.hasInkAlong({35, 5}, {35, 25}));
    }

    /// Close up, or if it is short, an outline of many lines is drawn as it is.
    void anOutlineThatIsNotDenseIsDrawnWhateverItsCorners()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        std::vector<LatticePoint> corners;
        for (int i = 0; i < 900; ++i) {
            const double angle = i * 2 * M_PI / 900;
            corners.push_back({Lattice(std::lround((20 + 10 * std::cos(angle)) * unitsPerPixel)),
                               Lattice(std::lround((15 + 10 * std::sin(angle)) * unitsPerPixel))});
        }
        sheet.frame.drawShapeOutline(polygonAt(corners));
        QVERIFY(sheet.hasInkAt(30, 15));
        QVERIFY(sheet.hasInkAt(20, 25));
        QVERIFY(!sheet.hasInkAlong({10, 5}, {15, 5})); // along its bounds

        Sheet closeUp(ViewMapping(frameOf(4000, 4000), {1, 1}, {0, 0}, 1));
        std::vector<LatticePoint> most = {latticePixel(10, 3990), latticePixel(600, 3990)};
        for (int i = 0; i < 50'000; ++i)
            most.push_back(latticePixel(2000 + i % 1900, 10 + i % 3000));
        closeUp.frame.drawShapeOutline(polygonAt(most));
        QVERIFY(closeUp.hasInkAlong({20, 3990}, {590, 3990}));
    }

    void theCornerOfACirclesBoxHangsOnTheCurve_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::newRow("circle") << circleAt(20, 15, 9);
        QTest::newRow("ellipse") << ellipseAtUnits(latticePixel(20, 15), 12 * unitsPerPixel,
                                                   5 * unitsPerPixel);
    }
    void theCornerOfACirclesBoxHangsOnTheCurve()
    {
        QFETCH(Shape, shape);
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        sheet.frame.drawShapeOutline(shape);
        const auto at = [&shape](std::size_t vertex) {
            const LatticePoint &point = shape.vertices[vertex].position;
            return QPointF(double(point.x), double(point.y)) / unitsPerPixel;
        };
        const QPointF centre = at(0), corner = at(1);
        // Dots along each tangent, near the corner and far from the curve; the lines are dotted.
        int dotsAcross = 0, dotsAlong = 0, dotsElsewhere = 0;
        for (double part = 0; part < 0.25; part += 0.02) {
            const QPointF on = corner - part * (corner - centre);
            dotsAlong += sheet.hasInkAt(on.x(), corner.y());
            dotsAcross += sheet.hasInkAt(corner.x(), on.y());
            dotsElsewhere += part > 0.1 && sheet.hasInkAt(on.x(), on.y());
        }
        QVERIFY(dotsAlong > 2 && dotsAcross > 2);
        QCOMPARE(dotsElsewhere, 0);
    }

    void everyTriangleHasAnOutlineHoweverFlatItIs_data()
    {
        QTest::addColumn<QList<QPoint>>("corners");
        QTest::addColumn<QPointF>("place");
        QTest::newRow("level") << QList<QPoint>{{5, 9}, {35, 9}, {25, 9}} << QPointF(15, 9);
        QTest::newRow("upright") << QList<QPoint>{{9, 5}, {9, 25}, {9, 20}} << QPointF(9, 10);
    }
    void everyTriangleHasAnOutlineHoweverFlatItIs()
    {
        QFETCH(QList<QPoint>, corners);
        QFETCH(QPointF, place);
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        std::array<LatticePoint, 3> points;
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = latticePixel(corners[qsizetype(i)].x(), corners[qsizetype(i)].y());
        sheet.frame.drawOutline(points, {});
        QVERIFY(sheet.hasInkAt(place.x(), place.y()));
    }

    void aNameKeepsClearOfItsHandleAtTheViewsBorder_data()
    {
        QTest::addColumn<QPointF>("position");
        QTest::newRow("left") << QPointF(4, 260);
        QTest::newRow("right") << QPointF(696, 260);
        QTest::newRow("top") << QPointF(350, 4);
        QTest::newRow("bottom left") << QPointF(3, 517);
    }
    void aNameKeepsClearOfItsHandleAtTheViewsBorder()
    {
        QFETCH(QPointF, position);
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        const LatticePoint point = sheet.mapping.latticeAt(position);
        sheet.frame.drawHandle(point, {{255, 0, 0}}, HandleState::Idle);
        QCOMPARE(sheet.frame.plates().size(), std::size_t(1));
        sheet.frame.drawVertexName(u"P0 (vertex 2)"_s, point, view.center());

        QCOMPARE(sheet.frame.plates().size(), std::size_t(2));
        QVERIFY(!sheet.frame.plates()[0].intersects(sheet.frame.plates()[1]));
        QVERIFY(view.contains(sheet.frame.plates()[1]));
    }

    void aNameStandsBesideItsVertexHoweverLongItIs()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        const LatticePoint point = sheet.mapping.latticeAt(view.center());
        const QPointF centre = sheet.mapping.positionOf(point);
        for (const QPointF &inside : {QPointF(0, 90), QPointF(90, 0), QPointF(60, 60),
                                      QPointF(-10, -90), QPointF(-90, 20)}) {
            Sheet one(sheet.mapping);
            one.frame.drawHandle(point, {{255, 0, 0}}, HandleState::Idle);
            one.frame.drawVertexName(u"P1 (vertex 2)"_s, point, centre + inside);
            const QRectF plate = one.frame.plates().back();
            QVERIFY(!one.frame.plates().front().intersects(plate));
            const QPointF nearest(std::clamp(centre.x(), plate.left(), plate.right()),
                                  std::clamp(centre.y(), plate.top(), plate.bottom()));
            const QPointF gap = nearest - centre;
            QVERIFY(std::hypot(gap.x(), gap.y()) < 16);
            QVERIFY(QPointF::dotProduct(plate.center() - centre, inside) < 0); // turned away
        }
    }

    void aLongNoteIsBrokenIntoLinesAndTakesAFreeCorner()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        QString words = u"a note of many words"_s;
        while (words.size() < 400)
            words += u" and more"_s;
        sheet.frame.drawCornerNote(words);
        const QRectF first = sheet.frame.plates().back();
        QVERIFY(view.contains(first));
        QVERIFY(first.height() > 2 * QFontMetricsF(sheet.painter.font()).height());
        QVERIFY(first.center().y() > view.center().y());

        Sheet taken(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        for (const QPointF &handle : {first.bottomLeft(), first.bottomRight()})
            taken.frame.drawHandle(taken.mapping.latticeAt(handle), {}, HandleState::Idle);
        taken.frame.drawCornerNote(words);
        const QRectF second = taken.frame.plates().back();
        QVERIFY(view.contains(second) && !second.intersects(first));
    }

    void aNoteStandsBesideTheFrameWhereThatLeavesItTheRoom()
    {
        // A tall, narrow frame in the middle.
        Sheet sheet(ViewMapping::fitted(frameOf(10, 30), view.toRect(), 1));
        sheet.frame.drawCornerNote(u"a note that goes into lines beside the frame, "
                                   "since one line would lie across it and hide "
                                   "some of its cells"_s);
        const QRectF note = sheet.frame.plates().back();
        QVERIFY(view.contains(note));
        const QRectF cells = sheet.mapping.devicePicture();
        QVERIFY(!note.intersects(cells));
        QVERIFY(note.center().x() < view.center().x() && note.center().y() > view.center().y());
    }

    void whereNoCornerIsFreeTheNoteCoversLeast()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        const QRectF within = view.adjusted(20, 15, -20, -15);
        const auto put = [&](const QPointF &place) {
            sheet.frame.drawHandle(sheet.mapping.latticeAt(place), {}, HandleState::Idle);
        };
        const QPointF middle = within.center();
        for (const QPointF &corner :
             {within.bottomLeft(), within.bottomRight(), within.topRight(),
              QPointF(middle.x(), within.top()), QPointF(middle.x(), within.bottom()),
              QPointF(within.left(), middle.y()), QPointF(within.right(), middle.y())}) {
            put(corner);
            put(corner);
        }
        put(within.topLeft());
        sheet.frame.drawCornerNote(u"a note"_s);
        const QPointF place = sheet.frame.plates().back().center();
        QVERIFY(place.x() < view.center().x() && place.y() < view.center().y());
    }

    void whereACornersNoteWouldCoverAHandleItStandsElsewhereOrInShorterLines()
    {
        const QString words = u"a note of many words and more and more and more and "
                              "more and more and more and more and more\nof two"_s;
        const QPointF middle = view.center();
        const QRectF within = view.adjusted(60, 20, -60, -20);
        std::vector<QPointF> handles;
        // One more handle each time; the last ones block long lines everywhere.
        for (const QPointF &next :
             {within.bottomLeft(), within.bottomRight(), within.topLeft(), within.topRight(),
              QPointF(middle.x(), within.bottom()), QPointF(middle.x(), within.top()), middle}) {
            handles.push_back(next);
            Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
            for (const QPointF &handle : handles)
                sheet.frame.drawHandle(sheet.mapping.latticeAt(handle), {}, HandleState::Idle);
            sheet.frame.drawCornerNote(words);

            const std::vector<QRectF> &plates = sheet.frame.plates();
            QCOMPARE(plates.size(), handles.size() + 1);
            QVERIFY(view.contains(plates.back()));
            for (std::size_t i = 0; i < handles.size(); ++i)
                QVERIFY(!plates[i].intersects(plates.back()));
        }
    }

    void thePointersNoteKeepsClearOfOtherNotes()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        sheet.frame.drawCornerNote(u"some\nlines\nof\na note\nthat is higher than\n"
                                   "what stands beside the pointer"_s);
        const QRectF note = sheet.frame.plates().back();
        for (double x = view.left() + 1; x < view.right(); x += 13) {
            for (double y = view.top() + 1; y < view.bottom(); y += 13) {
                sheet.frame.drawPointerNote(u"(27, 19)\ntriangle 0"_s, {x, y}, {});
                QVERIFY(view.contains(sheet.frame.plates().back()));
                QVERIFY(!note.intersects(sheet.frame.plates().back()));
            }
        }
    }

    void thePointersNoteKeepsClearOfWhatItIsTold()
    {
        Sheet sheet(ViewMapping::fitted(frameOf(40, 30), view.toRect(), 1));
        const QPointF pointer = view.center();
        const auto drawn = [&](const std::vector<QRectF> &places) {
            sheet.frame.drawPointerNote(u"(27, 19)\ntriangle 0"_s, pointer, places);
            return sheet.frame.plates().back();
        };
        const QRectF first = drawn({});
        QVERIFY(first.left() > pointer.x() && first.top() > pointer.y());
        std::vector<QRectF> places;
        for (int side = 0; side < 4; ++side) {
            const QRectF plate = drawn(places);
            QVERIFY(!plate.contains(pointer));
            for (const QRectF &place : places)
                QVERIFY(!place.intersects(plate));
            places.push_back(plate);
        }
        QCOMPARE(drawn(places), first); // no room is left: back to the first choice
    }

    void noNameCoversAnother_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("zoom");
        for (const char *file : {"default", "sliver", "stagnation", "ties-at-tenths",
                                 "vertical-edges", "shared-edge"}) {
            for (const int zoom : {3, 7, 10})
                QTest::addRow("%s at %d", file, zoom) << QString::fromLatin1(file) << zoom;
        }
    }
    void noNameCoversAnother()
    {
        QFETCH(QString, file);
        QFETCH(int, zoom);
        const auto reading = readSceneFile(resource(u"/scenes/%1.json"_s).arg(file));
        QVERIFY(reading);
        const auto traced = traceScene(reading->scene);
        const FrameSpec &spec = traced->scene.frame;
        const QPoint origin((700 - spec.width * zoom) / 2, (520 - spec.height * zoom) / 2);
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            Sheet sheet(ViewMapping(spec, ViewZoom::fromNumber(zoom), origin));
            const SpanRecord record = traced->trace->span(span);
            sheet.frame.drawEdgeTicks(record);
            const std::size_t primitive = traced->trace->primitiveOf(span);
            const std::array<Vertex, 3> &vertices
                = traced->primitives.triangles[primitive].vertices;
            QPointF inside;
            for (const Vertex &vertex : vertices)
                inside += sheet.mapping.positionOf(vertex.position) / 3;
            for (const Vertex &vertex : vertices)
                sheet.frame.drawVertexName(u"P0"_s, vertex.position, inside);
            const std::vector<QRectF> &plates = sheet.frame.plates();
            for (std::size_t i = 0; i < plates.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY2(!plates[i].intersects(plates[j]),
                             qPrintable(u"span %1, names %2 and %3"_s.arg(span).arg(j).arg(i)));
            }
        }
    }
};

PIXELPLUMB_TEST(TestFramePainter)

} // namespace tst_framepainter

#include "tst_framepainter.moc"
