// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layermoment.h"
#include "core/polygons/textoutlines.h"
#include "tests/support/numbernamed.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

namespace tst_edgetablelayer {

using namespace pixelplumb;

namespace {

Shape pentagon()
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = ShapeFill::EvenOdd;
    for (const QPoint &corner :
         {QPoint(5, 8), QPoint(26, 40), QPoint(56, 17), QPoint(41, 17), QPoint(33, 5)})
        polygon.vertices.push_back({latticePixel(corner.x(), corner.y()), Colour()});
    return polygon;
}

Shape filledPath()
{
    Shape path = bezierAt(
        {latticePixel(8, 6), latticePixel(60, 4), latticePixel(50, 44), latticePixel(10, 40)});
    path.fill = ShapeFill::EvenOdd;
    return path;
}

Shape textOf(const char *characters)
{
    Shape text;
    text.kind = PrimitiveKind::Text;
    text.vertices = {{latticePixel(6, 22), Colour()}};
    text.text = characters;
    text.textHeight = 18 * unitsPerPixel;
    return text;
}

/// The first row of the trace in which each edge is active, by edge number.
std::map<int, int> firstRows(const TracedScene &traced)
{
    std::map<int, int> rows;
    for (std::size_t span = 0; span < traced.trace->spanCount(); ++span) {
        const auto number = [&](const QString &id) { return spanNumber(traced, span, id); };
        for (int i = 0; i < 6; ++i) {
            const Quantity edge = number(u"edge_%1"_s.arg(i));
            if (!edge.isNone())
                rows.try_emplace(int(edge.toDouble()), int(number("y").toDouble()));
        }
    }
    return rows;
}

/// The rows named in labels, by edge number.
std::map<int, int> toldRows(const LayerDrawing &drawing)
{
    static const QRegularExpression pattern(u"^edge (\\d+), from row (-?\\d+)$"_s);
    std::map<int, int> rows;
    for (const LayerDrawing::Label &label : drawing.labels) {
        if (const auto match = pattern.match(label.text); match.hasMatch())
            rows[match.captured(1).toInt()] = match.captured(2).toInt();
    }
    return rows;
}

} // namespace

/// The edge table of shapes filled by parity: its buckets match the kernel's.
class TestEdgeTableLayer : public QObject {
    Q_OBJECT

private slots:
    void theBucketOfAnEdgeIsTheFirstRowThatHasItActive_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<PixelCentre>("centre");
        const auto addRows = [](const char *name, const Shape &shape, const char *method) {
            for (const auto origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft}) {
                for (const auto centre : {PixelCentre::Integer, PixelCentre::Half})
                    QTest::addRow("%s, y %s, %s centres", name,
                                  origin == FrameOrigin::TopLeft ? "downward" : "upward",
                                  centre == PixelCentre::Half ? "half" : "whole")
                        << shape << QByteArray(method) << origin << centre;
            }
        };
        addRows("polygon", pentagon(), "polygon-parity");
        addRows("filled path", filledPath(), "bezier-fill");
        if (textFontFile().isEmpty())
            return; // no outlines without a font
        addRows("text", textOf("l4"), "text-outlines");
        addRows("text of many edges", textOf("S"), "text-outlines");
    }
    void theBucketOfAnEdgeIsTheFirstRowThatHasItActive()
    {
        QFETCH(Shape, shape);
        QFETCH(QByteArray, method);
        QFETCH(FrameOrigin, origin);
        QFETCH(PixelCentre, centre);
        FrameSpec frame;
        frame.origin = origin;
        frame.pixelCentre = centre;
        Look look(sceneOf(shape, method.constData(), frame));
        const ScanTrace &trace = *look.traced->trace;
        const std::map<int, int> active = firstRows(*look.traced);

        std::map<int, int> told;
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            look.view.position = trace.indexOfSpan(span) + 1;
            told.merge(toldRows(look.drawing("edge-table")));
        }

        QVERIFY(active.size() >= 4);
        QCOMPARE(told, active);
    }

    /// At the top of this contour two edges meet the row at the same x.
    void edgesThatMeetARowAtOneXStandAsBelowIt_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<int>("row");
        QTest::addColumn<double>("left");
        // The row is treated as displaced downward on the screen, so the edges below it cross it.
        QTest::newRow("y upward") << FrameOrigin::BottomLeft << 14 << 2.0;
        QTest::newRow("y downward") << FrameOrigin::TopLeft << 3 << 3.0;
    }
    void edgesThatMeetARowAtOneXStandAsBelowIt()
    {
        QFETCH(FrameOrigin, origin);
        QFETCH(int, row);
        QFETCH(double, left);
        FrameSpec frame;
        frame.origin = origin;
        Shape polygon;
        polygon.kind = PrimitiveKind::Polygon;
        polygon.fill = ShapeFill::NonZero;
        for (const QPoint &corner : {QPoint(3, 3), QPoint(20, 4), QPoint(18, 14), QPoint(5, 13)})
            polygon.vertices.push_back({latticePixel(corner.x(), corner.y()), Colour()});
        if (origin == FrameOrigin::TopLeft)
            std::ranges::reverse(polygon.vertices); // counter-clockwise on the screen
        Look look(sceneOf(polygon, "polygon-parity", frame));
        const ScanTrace &trace = *look.traced->trace;
        std::size_t span = 0;
        while (trace.placeOf(span).coordinate != row)
            ++span;
        QCOMPARE(spanNumber(*look.traced, span, "x_0"), spanNumber(*look.traced, span, "x_1"));
        QCOMPARE(spanNumber(*look.traced, span, "edge_0").toDouble(), left);

        look.view.position = trace.indexOfSpan(span) + 1;
        const QStringList texts = textsOf(look.drawing("edge-table").labels);
        QVERIFY2(texts.contains(u"w = 1"_s), qPrintable(texts.join(u'|')));
        QVERIFY(!texts.contains(u"w = −1"_s));
    }

    void theLowestEdgesOfAPolygonBeginAboveTheirVertex()
    {
        const Look look(sceneOf(pentagon(), "polygon-parity", {}));

        // A vertex on a row, y upward: the sample on it is treated as lying below.
        const std::map<int, int> expected = {{0, 9}, {1, 18}, {3, 6}, {4, 6}};
        QCOMPARE(toldRows(look.drawing("edge-table")), expected);
    }

    void aLineLeadsFromEachEdgeToItsName()
    {
        const Shape polygon = pentagon();
        const LayerDrawing drawing
            = Look(sceneOf(polygon, "polygon-parity", {})).drawing("edge-table");
        int led = 0;
        for (const LayerDrawing::Line &line : drawing.lines) {
            if (line.stroke != LayerDrawing::Stroke::Dotted)
                continue;
            const auto name
                = std::ranges::find(drawing.labels, line.to, &LayerDrawing::Label::place);
            QVERIFY(name != drawing.labels.end());
            const auto edge = std::size_t(name->text.section(u' ', 1, 1).remove(u',').toInt());
            const QPointF from = placeOf(polygon.vertices[edge].position);
            const QPointF to
                = placeOf(polygon.vertices[(edge + 1) % polygon.vertices.size()].position);
            QCOMPARE(line.from, (from + to) / 2);
            ++led;
        }
        QCOMPARE(led, 4); // one edge lies along a row
    }

    void anEdgeBetweenTwoRowsIsInNoBucket()
    {
        Shape polygon = pentagon();
        polygon.vertices.push_back({{10 * unitsPerPixel, 7 * unitsPerPixel + halfPixel}, Colour()});
        const Look look(sceneOf(polygon, "polygon-parity", {}));

        // From (10, 7 1/2) to (5, 8) it crosses row 8; from (10, 7 1/8) to (9, 7 1/2) none.
        QCOMPARE(toldRows(look.drawing("edge-table")).at(5), 8);
        polygon.vertices.push_back({{9 * unitsPerPixel, 7 * unitsPerPixel + 32}, Colour()});
        QVERIFY(textsOf(Look(sceneOf(polygon, "polygon-parity", {})).drawing("edge-table").labels)
                    .contains(u"edge 5, on no row"_s));
    }
};

PIXELPLUMB_TEST(TestEdgeTableLayer)

} // namespace tst_edgetablelayer

#include "tst_edgetablelayer.moc"
