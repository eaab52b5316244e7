// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerlabels.h"
#include "core/layers/layermarks.h"
#include "core/polygons/textoutlines.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tst_layerpainting {

using namespace pixelplumb;

namespace {

/// The sum of the channel differences.
int distance(const QColor &a, const QColor &b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green())
        + std::abs(a.blue() - b.blue());
}

/// A white picture to paint on, of a frame of 8 by 6 pixels.
struct Paper {
    explicit Paper(double cell)
        : picture(int(8 * cell), int(6 * cell), QImage::Format_RGB32)
    {
        FrameSpec frame;
        frame.width = 8;
        frame.height = 6;
        picture.fill(Qt::white);
        surface = {pictureTransform(frame, {}, cell), picture.rect(), LayerTone::Light};
    }

    /// Whether a pixel in the rectangle is nearer to an ink than thin strokes would be.
    bool hasColour(const QRect &rect, LayerInk ink) const
    {
        const QColor colour = colourOf(ink, LayerTone::Light);
        for (int y = rect.top(); y <= rect.bottom(); ++y) {
            for (int x = rect.left(); x <= rect.right(); ++x) {
                if (picture.rect().contains(x, y)
                    && distance(picture.pixelColor(x, y), colour) < 190)
                    return true;
            }
        }
        return false;
    }

    QImage picture;
    LayerSurface surface;
};

LayerDrawing drawingWithSamples()
{
    LayerDrawing drawing;
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) {
            drawing.samples.push_back({{double(x), double(y)}, LayerInk::Third});
            drawing.cells.push_back({x, y, QString::number(y * 8 + x), LayerInk::First});
        }
    }
    drawing.cellNames = {u"address"_s};
    return drawing;
}

} // namespace

/// How the drawings of layers become pictures.
class TestLayerPainting : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
    }

    void subscriptsAreLoweredAndSmaller()
    {
        Glyphs glyphs;
        const QString symbol = u"d_lower = 1"_s;

        const double expected = glyphs.widthOf(u"d"_s) + 0.75 * glyphs.widthOf(u"lower"_s)
            + glyphs.widthOf(u" = 1"_s);
        QVERIFY(std::abs(glyphs.widthOf(symbol) - expected) < 1e-9);
        // "d" is on the baseline, "lower" below it: y grows downward.
        QVERIFY(glyphs.outlineOf(u"d"_s).boundingRect().bottom() < 0.05);
        QVERIFY(glyphs.outlineOf(symbol).boundingRect().bottom() > 0.1);
        QVERIFY(glyphs.widthOf(u"a_"_s)
                > glyphs.widthOf(u"a"_s)); // nothing follows that could be lowered
    }

    void numbersKeepClearOfTheSamplesInTheirCells()
    {
        Paper paper(32);
        QPainter painter(&paper.picture);

        const QStringList said
            = LayerPainter().paintNumbers(painter, drawingWithSamples(), paper.surface);
        LayerPainter().paintGround(painter, drawingWithSamples(), paper.surface);
        painter.end();

        QCOMPARE(said, QStringList("In the cells: address"));
        for (int x = 0; x < 8; ++x) {
            const QPoint centre = paper.surface.fromSamples.map(QPointF(x, 2)).toPoint();
            QCOMPARE(paper.picture.pixelColor(centre), colourOf(LayerInk::Third, LayerTone::Light));
            // The number is below the sample, none across it or above.
            QVERIFY(paper.hasColour({centre.x() - 14, centre.y() + 4, 28, 11}, LayerInk::First));
            QVERIFY(!paper.hasColour({centre.x() - 14, centre.y() - 15, 28, 19}, LayerInk::First));
        }
    }

    void whatHasNoRoomInTheCellsIsNamedAndNotSaidToBeThere()
    {
        Paper paper(24);
        QPainter painter(&paper.picture);
        LayerDrawing drawing;
        for (const char *text : {"0.5", "0.25", "0.25", "128", "63.8"})
            drawing.cells.push_back({1, 1, QString::fromLatin1(text)});
        drawing.cellNames = {u"α, β, γ"_s, u"R, G"_s};

        QStringList said = LayerPainter().paintNumbers(painter, drawing, paper.surface);
        QCOMPARE(said,
                 QStringList("No room for the numbers in the cells (α, β, γ, R, G): they need "
                             "cells of 40 pixels; enlarge the picture, or show fewer layers"));

        Paper larger(40);
        QPainter again(&larger.picture);
        said = LayerPainter().paintNumbers(again, drawing, larger.surface);
        QCOMPARE(said, QStringList("In the cells, from the top: α, β, γ, R, G"));
    }

    void cellsThatAreLargeEnoughForTheNumbersBesideTheSamplesAreTold()
    {
        LayerDrawing drawing = drawingWithSamples();
        for (int i = 0; i < 2; ++i)
            drawing.cells.push_back({3, 3, u"1"_s, LayerInk::First});
        const auto saidAt = [&drawing](double cell) {
            Paper paper(cell);
            QPainter painter(&paper.picture);
            return LayerPainter().paintNumbers(painter, drawing, paper.surface).front();
        };

        // Three lines of 6 px below the dot in the middle.
        QVERIFY2(saidAt(56).contains("cells of 57 pixels"), qPrintable(saidAt(56)));
        QCOMPARE(saidAt(57), u"In the cells: address"_s);
    }

    void aMeasureStandsBesideWhatItMeasures()
    {
        Paper paper(40);
        QPainter painter(&paper.picture);
        LayerDrawing drawing;
        drawing.measures = {{{3, 2}, {3, 2.75}, u"d_lower"_s, LayerInk::First},
                            {{3, 2.75}, {3, 3}, u"d_upper"_s, LayerInk::Second}};

        LayerPainter().paintMarks(painter, drawing, paper.surface);
        painter.end();

        const QLineF column(paper.surface.fromSamples.map(QPointF(3, 0)),
                            paper.surface.fromSamples.map(QPointF(3, 5)));
        const double lower = paper.surface.fromSamples.map(QPointF(3, 2.4)).y();
        const double upper = paper.surface.fromSamples.map(QPointF(3, 2.9)).y();
        const int x = int(column.x1());
        // Nothing on the column; to the right of it both, each in its ink.
        QCOMPARE(paper.picture.pixelColor(x, int(lower)), QColor(Qt::white));
        QVERIFY(paper.hasColour({x + 8, int(lower), 8, 1}, LayerInk::First));
        QVERIFY(paper.hasColour({x + 8, int(upper), 8, 1}, LayerInk::Second));
        QVERIFY(!paper.hasColour({x + 8, int(upper), 8, 1}, LayerInk::First));
    }

    void namesKeepClearOfMeasures()
    {
        Paper paper(40);
        QPainter painter(&paper.picture);
        LayerDrawing drawing;
        drawing.measures = {{{3, 2}, {3, 2.75}, u"d_lower"_s, LayerInk::First},
                            {{3, 2.75}, {3, 3}, u"d_upper"_s, LayerInk::Second}};
        drawing.labels = {{u"p_k"_s, {3, 2.75}, LayerInk::Hand}};

        LayerPainter layers;
        QVERIFY(layers.paintLabels(painter, drawing, paper.surface, {}).isEmpty());

        QCOMPARE(layers.labels().size(), std::size_t(3));
        for (const QRectF &label : layers.labels()) {
            for (const LayerDrawing::Measure &measure : drawing.measures)
                QVERIFY(!label.intersects(measureRect(measure, paper.surface)));
        }
    }

    void measuresOfOppositeWaysStandOnBothSides()
    {
        Paper paper(40);
        // The line has left the two pixels: one of the distances is negative.
        const QLineF one = measureLine({{3, 2}, {3, 1.75}, {}, LayerInk::First}, paper.surface);
        const QLineF other = measureLine({{3, 1.75}, {3, 3}, {}, LayerInk::Second}, paper.surface);
        const double x = paper.surface.fromSamples.map(QPointF(3, 0)).x();

        QVERIFY(one.x1() < x - 8);
        QVERIFY(other.x1() > x + 8);
    }

    void plainEdgesLieInTheGroundAndFiguresAboveIt()
    {
        LayerDrawing drawing;
        drawing.lines = {{{0, 1}, {7, 1}, LayerInk::Mark},
                         {{0, 3}, {7, 3}, LayerInk::Inside, LayerDrawing::Stroke::Band}};
        const auto inked = [&](bool isGround) {
            Paper paper(20);
            QPainter painter(&paper.picture);
            if (isGround)
                LayerPainter().paintGround(painter, drawing, paper.surface);
            else
                LayerPainter().paintMarks(painter, drawing, paper.surface);
            painter.end();
            const auto at = [&](double y) {
                return paper.picture.pixelColor(
                           paper.surface.fromSamples.map(QPointF(3, y)).toPoint())
                    != QColor(Qt::white);
            };
            return std::pair(at(1), at(3));
        };

        QCOMPARE(inked(true), std::pair(true, false));
        QCOMPARE(inked(false), std::pair(false, true));
    }

    /// A name leaves its usual place, though there is room, if a rival is nearer to it.
    void aNameIsNotNearerToAnotherNamesTarget()
    {
        Paper paper(40);
        QPainter painter(&paper.picture);
        Glyphs glyphs;
        const QTransform toSamples = paper.surface.fromSamples.inverted();
        const QPointF place(160, 120);
        const QLineF rival(place + QPointF(10, -100), place + QPointF(10, 100));
        LayerDrawing::Label label{u"name"_s, toSamples.map(place), LayerInk::First};
        const auto rectOf = [&](const LayerDrawing::Label &placed) {
            LayerLabels labels(painter, paper.surface, glyphs, {});
            labels.place(placed);
            return labels.places().front();
        };
        QVERIFY(rectOf(label).left() > place.x());

        label.rivals = {toSamples.map(rival)};
        QVERIFY(rectOf(label).right() < place.x());
        // Rivals from both sides: where no place is nearer, the name is shown nevertheless.
        label.rivals.push_back(toSamples.map(rival.translated(-20, 0)));
        label.rivals.push_back(toSamples.map(QLineF(place, place + QPointF(1, 0))));
        QVERIFY(rectOf(label).left() > place.x());
    }

    void linesToNamesStrikeNoNameThrough()
    {
        Paper paper(40);
        QPainter painter(&paper.picture);
        Glyphs glyphs;
        LayerLabels labels(painter, paper.surface, glyphs, {});
        // So close together that names have to move away.
        const QTransform toSamples = paper.surface.fromSamples.inverted();
        for (int i = 0; i < 9; ++i)
            labels.place({u"name %1"_s.arg(i), toSamples.map(QPointF(160 + 2 * i, 120 + i)),
                          LayerInk::First});
        labels.paint();
        painter.end();

        // Each name has a background that nearly hides a line below it.
        QCOMPARE(labels.places().size(), std::size_t(9));
        QCOMPARE(labels.omitted(), std::size_t(0));
        for (std::size_t i = 0; i < 9; ++i) {
            Paper alone(40);
            QPainter single(&alone.picture);
            LayerTexts texts(single, alone.surface, glyphs);
            const QRectF rect = labels.places()[i];
            texts.paintPaper(rect);
            texts.paintText(u"name %1"_s.arg(i), rect.topLeft() + QPointF(3, 1 + ascent * 12), 12,
                            LayerInk::First);
            single.end();
            // Only the inner part: lines may end at the border.
            const QRect inside = rect.toAlignedRect().adjusted(4, 3, -4, -3);
            int largest = 0;
            for (int y = inside.top(); y <= inside.bottom(); ++y) {
                for (int x = inside.left(); x <= inside.right(); ++x)
                    largest = std::max(
                        largest,
                        distance(paper.picture.pixelColor(x, y), alone.picture.pixelColor(x, y)));
            }
            QVERIFY2(largest < 120, qPrintable(QString::number(largest)));
        }
    }
};

PIXELPLUMB_TEST(TestLayerPainting)

} // namespace tst_layerpainting

#include "tst_layerpainting.moc"
