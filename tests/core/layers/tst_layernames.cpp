// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layermarks.h"
#include "core/polygons/textoutlines.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

namespace tst_layernames {

using namespace pixelplumb;

namespace {

Triangle triangleAt(const QPoint &a, const QPoint &b, const QPoint &c)
{
    const auto vertex = [](const QPoint &place) {
        return Vertex{latticePixel(place.x(), place.y()), Colour()};
    };
    return {{vertex(a), vertex(b), vertex(c)}};
}

/// The text at this place that begins this way.
QString labelAt(const std::vector<LayerDrawing::Label> &labels, const QPointF &place,
                const QString &beginning)
{
    const auto found = std::ranges::find_if(labels, [&](const LayerDrawing::Label &label) {
        return label.text.startsWith(beginning) && label.place == place;
    });
    return found == labels.end() ? QString() : found->text;
}

double distanceOf(const QRectF &rect, const QPointF &point)
{
    return std::hypot(std::max({0.0, rect.left() - point.x(), point.x() - rect.right()}),
                      std::max({0.0, rect.top() - point.y(), point.y() - rect.bottom()}));
}

/// The distance from an infinite line; 0 if it meets the rectangle.
double distanceOf(const QRectF &rect, const QLineF &line)
{
    const QLineF normal = line.normalVector().unitVector();
    double least = INFINITY;
    double largest = -INFINITY;
    for (const QPointF &corner :
         {rect.topLeft(), rect.topRight(), rect.bottomLeft(), rect.bottomRight()}) {
        const double side = QPointF::dotProduct(corner - line.p1(), normal.p2() - normal.p1());
        least = std::min(least, side);
        largest = std::max(largest, side);
    }
    return std::max({0.0, least, -largest});
}

/// A picture of a frame of 8 by 6 pixels, 40 px per cell.
struct Paper {
    Paper()
        : picture(8 * 40, 6 * 40, QImage::Format_RGB32)
    {
        FrameSpec frame;
        frame.width = 8;
        frame.height = 6;
        surface = {pictureTransform(frame, {}, 40), picture.rect(), LayerTone::Light};
    }

    QImage picture;
    LayerSurface surface;
};

} // namespace

/// Layers shown together use a name for the same thing, and names are near what they name.
class TestLayerNames : public QObject {
    Q_OBJECT

private slots:
    void allLayersMeanTheSameByWeightsAndVertices_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<Triangle>("triangle");
        // One triangle with its vertices in three orders, the first an order that no method sorts
        // into.
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle))
                continue;
            const QByteArray id = method.id.toLatin1();
            const QPoint high(6, 10), right(14, 3), low(2, 0);
            QTest::addRow("%s, highest first", id.data()) << id << triangleAt(high, right, low);
            QTest::addRow("%s, rightmost first", id.data()) << id << triangleAt(right, low, high);
            QTest::addRow("%s, clockwise", id.data()) << id << triangleAt(right, high, low);
        }
    }
    void allLayersMeanTheSameByWeightsAndVertices()
    {
        QFETCH(QByteArray, method);
        QFETCH(Triangle, triangle);
        Scene scene;
        scene.method = method.toStdString();
        scene.triangles = {triangle};
        Look look(scene);
        const std::vector<LayerDrawing::Label> axes = look.drawing("barycentric-axes").labels;
        const std::vector<LayerDrawing::Label> vertices = look.drawing("vertices").labels;
        const std::vector<LayerDrawing::Label> images = look.drawing("affine-map").labels;
        const LayerDrawing weights = look.drawing("weights");
        for (std::size_t i = 0; i < 3; ++i) {
            const QChar letter(char16_t(u'a' + i));
            const QPointF corner = placeOf(triangle.vertices[i].position);
            const QString axis = labelAt(axes, corner, letter + u" = P"_s);
            QVERIFY2(!axis.isEmpty(), qPrintable(textsOf(axes).join('|')));
            const QChar rank = axis[5];
            const QString vertex = labelAt(vertices, corner, u"P"_s + rank);
            QVERIFY2(vertex.startsWith(rank.digitValue() == int(i)
                                           ? u"P%1 ("_s.arg(i)
                                           : u"P%1 = vertex %2 ("_s.arg(rank).arg(i)),
                     qPrintable(textsOf(vertices).join('|')));
            QVERIFY2(
                axis.endsWith(QStringList{"(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"}[qsizetype(i)]),
                qPrintable(axis));
            const QString image = u"%1′ = P%2′ "_s.arg(letter).arg(rank);
            QVERIFY2(textsOf(images).filter(image).size() == 1,
                     qPrintable(textsOf(images).join('|')));
        }
        // The same sample has the same value in its cell and in the label of the affine map.
        if (weights.cellNames.contains(u"E₀"_s))
            return;
        QVERIFY(!weights.cells.empty());
        for (std::size_t cell = 0; cell + 2 < weights.cells.size(); cell += 3) {
            const LayerDrawing::CellText &first = weights.cells[cell];
            look.view.picked = QPoint(int(first.x), int(first.y));
            const auto labels = textsOf(look.drawing("affine-map").labels).filter("p: ");
            QCOMPARE(labels.size(), 1);
            QStringList parts = labels.front().sliced(3).split(u", "_s);
            for (qsizetype i = 0; i < 3; ++i) {
                const QStringList fraction
                    = parts[i].section(u' ', -1).replace(u'−', u'-').split(u'/');
                const double weight
                    = fraction[0].toDouble() / (fraction.size() > 1 ? fraction[1].toDouble() : 1);
                QString inCell = weights.cells[cell + std::size_t(i)].text;
                // Cells show three digits.
                QVERIFY2(std::abs(inCell.replace(u'−', u'-').toDouble() - weight)
                             < 0.006 * std::max(1.0, std::abs(weight)),
                         qPrintable(labels.front() + " beside " + inCell));
            }
        }
    }

    void theTextsOfADecisionStandBesideTheirOwnBars_data()
    {
        QTest::addColumn<Shape>("line");
        QTest::newRow("the slides' example") << lineAt(20, 41, 30, 44);
        QTest::newRow("falling") << lineAt(20, 41, 30, 38);
        QTest::newRow("steep") << lineAt(20, 10, 23, 20);
        QTest::newRow("steep, to the left") << lineAt(30, 10, 26, 21);
        QTest::newRow("level") << lineAt(20, 20, 30, 20);
        QTest::newRow("45 degrees") << lineAt(20, 10, 30, 20);
    }
    void theTextsOfADecisionStandBesideTheirOwnBars()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
        QFETCH(Shape, line);
        Look look(sceneOf(line, "line-bresenham", {}));
        const auto distance = [](const QRectF &a, const QRectF &b) {
            return std::hypot(std::max({0.0, a.left() - b.right(), b.left() - a.right()}),
                              std::max({0.0, a.top() - b.bottom(), b.top() - a.bottom()}));
        };
        for (int scale = 8; scale <= 64; scale += scale < 24 ? 1 : 4) {
            QImage picture(64 * scale, 48 * scale, QImage::Format_RGB32);
            QPainter painter(&picture);
            look.view.cell = scale;
            const LayerSurface surface{pictureTransform(look.traced->scene.frame, {}, scale),
                                       picture.rect(), LayerTone::Light};
            for (look.view.position = 1; look.view.position <= look.traced->trace->stepCount();
                 ++look.view.position) {
                const LayerDrawing drawing = drawingOf({u"decisions"_s, u"vertices"_s}, look.view);
                if (drawing.measures.empty())
                    continue; // no decision led to the first pixel
                const std::vector<QRectF> bars = LayerPainter::measurePlaces(drawing, surface);
                LayerPainter layers;
                layers.paintLabels(painter, drawing, surface, {});
                const std::vector<QRectF> &labels = layers.labels();
                const QByteArray moment = "scale " + QByteArray::number(scale) + ", step "
                    + QByteArray::number(int(look.view.position));
                QVERIFY2(labels.size() >= 2, moment.data());
                for (const std::size_t own : {std::size_t(0), std::size_t(1)}) {
                    const double toOwn = distance(labels[own], bars[own]);
                    QVERIFY2(toOwn < 20, moment.data());
                    QVERIFY2(toOwn < distance(labels[own], bars[1 - own]) + 1e-6, moment.data());
                }
                // The texts are arranged as the pixels are.
                const QPointF way = drawing.measures[1].to - drawing.measures[0].from;
                const QPointF shown
                    = surface.fromSamples.map(way) - surface.fromSamples.map(QPointF());
                QVERIFY2(QPointF::dotProduct(labels[1].center() - labels[0].center(), shown) > 0,
                         moment.data());
            }
        }
    }

    void namesKeepClearOfPointsAndBands()
    {
        Paper paper;
        QPainter painter(&paper.picture);
        LayerDrawing drawing;
        drawing.lines = {{{1, 3}, {6, 3}, LayerInk::Inside, LayerDrawing::Stroke::Band}};
        for (int x = 1; x <= 6; ++x) {
            drawing.points.push_back({{double(x), 3}, LayerInk::Hand});
            drawing.labels.push_back(
                {u"edge %1, from row 3"_s.arg(x), {x + 0.3, 3.3}, LayerInk::Mark});
        }

        LayerPainter layers;
        QVERIFY(layers.paintLabels(painter, drawing, paper.surface, {}).isEmpty());

        const QTransform &toPaper = paper.surface.fromSamples;
        QCOMPARE(layers.labels().size(), std::size_t(6));
        for (const QRectF &label : layers.labels()) {
            QVERIFY(!label.intersects(QRectF(toPaper.map(QPointF(1, 3)), toPaper.map(QPointF(6, 3)))
                                          .adjusted(0, -bandWidth / 2, 0, bandWidth / 2)));
            for (const LayerDrawing::Point &point : drawing.points)
                QVERIFY(!label.contains(toPaper.map(point.place)));
        }
    }

    /// For small triangles, whose names hardly fit next to them.
    void namesOfHalfPlanesStandInTheirHalfPlane_data()
    {
        QTest::addColumn<Triangle>("triangle");
        QTest::newRow("the slide's edge") << triangleAt(QPoint(3, 2), QPoint(2, 4), QPoint(1, 1));
        QTest::newRow("turned over") << triangleAt(QPoint(3, 2), QPoint(1, 1), QPoint(2, 4));
        QTest::newRow("flat") << triangleAt(QPoint(2, 2), QPoint(6, 3), QPoint(4, 3));
        QTest::newRow("in a corner") << triangleAt(QPoint(0, 0), QPoint(2, 0), QPoint(0, 2));
        QTest::newRow("large") << triangleAt(QPoint(0, 0), QPoint(7, 1), QPoint(2, 5));
    }
    void namesOfHalfPlanesStandInTheirHalfPlane()
    {
        QFETCH(Triangle, triangle);
        Scene scene;
        scene.method = "edge-equations";
        scene.frame.width = 8;
        scene.frame.height = 6;
        scene.triangles = {triangle};
        Look look(scene);
        look.view.cell = 40;
        std::size_t shown = 0;
        for (const char *layer : {"half-plane-0", "half-plane-1", "half-plane-2"}) {
            const LayerDrawing all = look.drawing(layer);
            const auto arrow = std::ranges::find(all.lines, LayerDrawing::Stroke::Arrow,
                                                 &LayerDrawing::Line::stroke);
            QVERIFY(arrow != all.lines.end());
            for (const LayerDrawing::Label &name : all.labels) {
                LayerDrawing drawing = all;
                drawing.labels = {name};
                Paper paper;
                QPainter painter(&paper.picture);
                LayerPainter layers;
                layers.paintLabels(painter, drawing, paper.surface, {});
                const QPointF middle = paper.surface.fromSamples.map(arrow->from);
                QPointF inward = paper.surface.fromSamples.map(arrow->to) - middle;
                if (name.text.contains(u"< 0"_s))
                    inward = -inward;
                for (const QRectF &rect : layers.labels()) {
                    for (const QPointF &corner :
                         {rect.topLeft(), rect.topRight(), rect.bottomLeft(), rect.bottomRight()})
                        QVERIFY2(QPointF::dotProduct(corner - middle, inward) >= 0,
                                 qPrintable(name.text));
                    ++shown;
                }
            }
        }
        QVERIFY2(shown >= 2, qPrintable(QString::number(shown)));
    }

    /// A name outside a small triangle is on the line of its own edge.
    void eachArrowOfASmallTriangleIsNearestToItsOwnNames_data()
    {
        QTest::addColumn<Triangle>("triangle");
        QTest::newRow("small") << triangleAt(QPoint(20, 20), QPoint(31, 22), QPoint(25, 30));
        QTest::newRow("smaller") << triangleAt(QPoint(20, 20), QPoint(26, 21), QPoint(23, 25));
        QTest::newRow("turned over") << triangleAt(QPoint(20, 20), QPoint(25, 30), QPoint(31, 22));
    }
    void eachArrowOfASmallTriangleIsNearestToItsOwnNames()
    {
        QFETCH(Triangle, triangle);
        Scene scene;
        scene.method = "edge-equations";
        scene.triangles = {triangle};
        Look look(scene);
        look.view.cell = 8;
        const LayerDrawing drawing = look.drawing("half-planes");
        QImage picture(scene.frame.width * 8, scene.frame.height * 8, QImage::Format_RGB32);
        const LayerSurface surface{pictureTransform(scene.frame, {}, 8), picture.rect(),
                                   LayerTone::Light};
        QPainter painter(&picture);
        LayerPainter layers;
        layers.paintLabels(painter, drawing, surface, {});
        QCOMPARE(layers.labels().size(), std::size_t(6));

        // A dashed line and an arrow for each edge in turn; of the names, the negative one comes
        // first.
        QCOMPARE(drawing.lines.size(), std::size_t(6));
        for (std::size_t name = 0; name < 6; ++name) {
            const bool isNegative = drawing.labels[name].text.contains(u" < 0"_s);
            std::array<double, 3> distances{};
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const LayerDrawing::Line &line = drawing.lines[2 * edge];
                const QPointF arrow = drawing.lines[2 * edge + 1].from;
                const QLineF seen = surface.fromSamples.map(QLineF(line.from, line.to));
                distances[edge] = isNegative
                    ? distanceOf(layers.labels()[name], surface.fromSamples.map(arrow))
                    : distanceOf(layers.labels()[name], seen);
            }
            const auto nearest = std::ranges::min_element(distances) - distances.begin();
            QVERIFY2(drawing.labels[name].text.startsWith(
                         u'E' + QString(QChar(char16_t(u'₀' + nearest)))),
                     qPrintable(drawing.labels[name].text));
        }
    }

    void aNormalOfASolvedEdgeHasDigitsThatCount()
    {
        // F₀ = (y − y₀) − m·(x − x₀), divided by its value at the third vertex.
        Scene scene;
        scene.method = "edge-equations-solved";
        scene.frame.firstColumn = 390;
        scene.frame.firstRow = 290;
        scene.triangles = {triangleAt(QPoint(400, 300), QPoint(440, 304), QPoint(410, 330))};
        const QStringList texts = textsOf(Look(scene).drawing("half-planes").labels);

        // −1/2600 and 1/260, −13/10280 and −3/2056, 1/300 and −1/900.
        for (const char *text :
             {"E₀ > 0, normal <−0.000385, 0.00385>", "E₁ > 0, normal <−0.00126, −0.00146>",
              "E₂ > 0, normal <0.00333, −0.00111>"})
            QVERIFY2(texts.contains(QString::fromUtf8(text)), qPrintable(texts.join(u'\n')));
    }

    void numbersInCellsHaveADigitThatCounts()
    {
        const auto text = [](std::int64_t numerator, std::int64_t denominator) {
            return cellNumber(Quantity::rational(numerator, denominator));
        };
        QCOMPARE(text(-451, 4), u"−112.8"_s);
        QCOMPARE(text(1, 3), u"0.33"_s);
        QCOMPARE(text(-1, 70), u"−0.014"_s);
        QCOMPARE(text(-1, 30000), u"−3e−05"_s);
        QCOMPARE(text(0, 1), u"0"_s);
        QCOMPARE(preciseNumber(Quantity::rational(-16, 1117)), u"−0.0143"_s);
        QCOMPARE(preciseNumber(Quantity::rational(45, 2)), u"22.5"_s);
    }

    /// An edge whose middle is far outside has its arrow where the edge is visible.
    void everyNameThatToldANormalHasAnArrowInView()
    {
        Scene scene;
        scene.method = "edge-equations";
        scene.triangles = {triangleAt(QPoint(-200, 20), QPoint(300, 22), QPoint(60, 25))};
        Look look(scene);
        look.view.cell = 12;
        const LayerDrawing drawing = look.drawing("half-planes");
        const QRectF frame(0, 0, scene.frame.width, scene.frame.height);
        QCOMPARE(drawing.lines.size(), std::size_t(6));
        for (const LayerDrawing::Line &line : drawing.lines)
            QVERIFY(line.stroke != LayerDrawing::Stroke::Arrow || frame.contains(line.from));
    }

    void aFiguresLinesAreWhereANoteHadBetterNotStand()
    {
        const Paper paper;
        LayerDrawing drawing;
        // From the middle to far outside the view.
        drawing.lines = {{{3, 2}, {3, 900}, LayerInk::First}};

        const std::vector<QRectF> places = LayerPainter::figurePlaces(drawing, paper.surface);

        const QPointF middle = paper.surface.fromSamples.map(QPointF(3, 2));
        double covered = 0;
        for (const QRectF &place : places) {
            QVERIFY(std::abs(place.center().x() - middle.x()) < 1e-9);
            QVERIFY(place.intersects(paper.surface.view));
            covered += place.height();
        }
        QVERIFY(std::abs(covered - middle.y()) < 9); // from there to the upper border
    }
};

PIXELPLUMB_TEST(TestLayerNames)

} // namespace tst_layernames

#include "tst_layernames.moc"
