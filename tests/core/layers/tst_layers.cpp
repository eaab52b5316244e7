// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerpainter.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <QRectF>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_layers {

using namespace pixelplumb;

namespace {

Scene sceneBy(const char *method, const Triangle &triangle)
{
    Scene scene;
    scene.method = method;
    scene.triangles = {triangle};
    return scene;
}

/// (4, 5) (58, 12) (26 1/2, 44), counter-clockwise.
Triangle firstTriangle()
{
    return triangleAtUnits(latticePixel(4, 5), latticePixel(58, 12),
                           {26 * unitsPerPixel + halfPixel, 44 * unitsPerPixel});
}

bool contains(const LayerDrawing::Area &area, const QPointF &point)
{
    return QPolygonF(QList<QPointF>(area.corners.begin(), area.corners.end()))
        .containsPoint(point, Qt::OddEvenFill);
}

LayerSurface surfaceOf(const Look &look, const QImage &picture)
{
    return {pictureTransform(look.traced->scene.frame, {}, look.view.cell), picture.rect(),
            LayerTone::Light};
}

std::ptrdiff_t areasAround(const LayerDrawing &drawing, const QPointF &point)
{
    return std::ranges::count_if(
        drawing.areas, [&point](const LayerDrawing::Area &area) { return contains(area, point); });
}

} // namespace

/// The course texts' figures drawn over a scene, with the numbers of the run.
class TestLayers : public QObject {
    Q_OBJECT

private slots:
    void theBoxIsRawAndAsPrintedAndAsTested_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<PixelCentre>("centre");
        QTest::addColumn<QStringList>("labels");
        // (int)(44 − .5) = 43: the rounding printed on the slides is for samples at pixel centres.
        // The last column, 70, lies outside a frame of 64, whose last is 63.
        const QStringList integer
            = {"bbox: x 4 1/4 … 70, y 5 … 44", "(int)(bbox ± .5), clipped: x 4 … 63, y 5 … 43",
               "tested: x 5 … 63, y 5 … 44"};
        const QStringList half
            = {"bbox: x 4 1/4 … 70, y 5 … 44", "(int)(bbox ± .5), clipped: x 4 … 63, y 5 … 43",
               "tested: x 4 … 63, y 5 … 43"};
        QTest::newRow("rows of tests")
            << QByteArray("edge-equations") << PixelCentre::Integer << integer;
        QTest::newRow("columns of tests")
            << QByteArray("barycentric-rectangle") << PixelCentre::Integer << integer;
        QTest::newRow("no tests") << QByteArray("column-scan") << PixelCentre::Integer
                                  << QStringList{integer[0], integer[1],
                                                 "clipped: x 5 … 63, y 5 … 44"};
        QTest::newRow("in the middle of pixels")
            << QByteArray("edge-equations") << PixelCentre::Half << half;
        QTest::newRow("the whole frame is tested")
            << QByteArray("barycentric-all") << PixelCentre::Integer
            << QStringList{integer[0], integer[1], "tested: x 0 … 63, y 0 … 47"};
    }
    void theBoxIsRawAndAsPrintedAndAsTested()
    {
        QFETCH(QByteArray, method);
        QFETCH(PixelCentre, centre);
        QFETCH(QStringList, labels);
        Scene scene = sceneBy(method.constData(),
                              triangleAtUnits({4 * unitsPerPixel + 64, 5 * unitsPerPixel},
                                              latticePixel(70, 12), latticePixel(26, 44)));
        scene.frame.pixelCentre = centre;

        QCOMPARE(textsOf(Look(scene).drawing("box").labels), labels);
    }

    void verticesHaveTheNamesThatTheMethodGivesThem_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<QStringList>("names");
        QTest::newRow("in the order of columns")
            << QByteArray("column-scan")
            << QStringList{"P0 = vertex 1 (−2, 0)", "P1 = vertex 2 (3, 9)",
                           "P2 = vertex 0 (12, 3 1/2)"};
        QTest::newRow("as given") << QByteArray("edge-equations")
                                  << QStringList{"P0 (12, 3 1/2)", "P1 (−2, 0)", "P2 (3, 9)"};
    }
    void verticesHaveTheNamesThatTheMethodGivesThem()
    {
        QFETCH(QByteArray, method);
        QFETCH(QStringList, names);
        const LayerDrawing drawing
            = Look(sceneBy(method.constData(),
                           triangleAtUnits({12 * unitsPerPixel, 3 * unitsPerPixel + halfPixel},
                                           latticePixel(-2, 0), latticePixel(3, 9))))
                  .drawing("vertices");

        QCOMPARE(textsOf(drawing.labels), names);
        QCOMPARE(drawing.lines.size(), std::size_t(3));
    }

    void theNormalsAreTheNumbersOfTheSetUp()
    {
        const Look look(sceneBy("edge-equations", firstTriangle()));
        const LayerDrawing drawing = look.drawing("half-planes");
        const SetUpRecord setUp = look.traced->trace->setUp(0);
        const NamedNumbers numbers(look.traced->trace->numbers().setUp, setUp.cells);

        std::size_t edge = 0;
        for (const LayerDrawing::Line &line : drawing.lines) {
            if (line.stroke != LayerDrawing::Stroke::Arrow)
                continue;
            const QPointF normal(numbers[u"a_%1"_s.arg(edge)].toDouble(),
                                 numbers[u"b_%1"_s.arg(edge)].toDouble());
            const QPointF arrow = line.to - line.from;
            QVERIFY(QPointF::dotProduct(arrow, normal) > 0);
            QVERIFY(std::abs(arrow.x() * normal.y() - arrow.y() * normal.x()) < 1e-9);
            ++edge;
        }
        QCOMPARE(edge, std::size_t(3));
        QVERIFY(textsOf(drawing.labels).contains(u"E₀ > 0, normal <−7, 54>"_s));
        QVERIFY(textsOf(drawing.labels).contains(u"E₂ > 0, normal <39, −22.5>"_s));
        QVERIFY(drawing.notes.isEmpty());
    }

    void halfPlanesAreTintedWhereTheKernelsFunctionsArePositive_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<bool>("turned");
        QTest::addColumn<int>("inside");
        QTest::newRow("flipped to be positive inside") << QByteArray("edge-equations") << true << 3;
        QTest::newRow("f_bc of a counter-clockwise triangle")
            << QByteArray("barycentric-rectangle") << false << 0;
        QTest::newRow("f_bc of a clockwise triangle")
            << QByteArray("barycentric-rectangle") << true << 3;
        QTest::newRow("the oracle's") << QByteArray("column-scan") << true << 3;
    }
    void halfPlanesAreTintedWhereTheKernelsFunctionsArePositive()
    {
        QFETCH(QByteArray, method);
        QFETCH(bool, turned);
        QFETCH(int, inside);
        Triangle triangle = firstTriangle();
        if (turned)
            std::swap(triangle.vertices[1], triangle.vertices[2]);

        const LayerDrawing drawing
            = Look(sceneBy(method.constData(), triangle)).drawing("half-planes");

        QCOMPARE(drawing.areas.size(), std::size_t(3));
        QCOMPARE(areasAround(drawing, {28, 20}), std::ptrdiff_t(inside));
    }

    void namesOfHalfPlanesKeepClearOfASmallTriangle_data()
    {
        QTest::addColumn<double>("cell");
        for (const double cell : {4.0, 12.0, 32.0})
            QTest::addRow("%g px a cell", cell) << cell;
    }
    void namesOfHalfPlanesKeepClearOfASmallTriangle()
    {
        QFETCH(double, cell);
        Look look(sceneBy("edge-equations", triangleAt(25, 24, 31, 25, 28, 29)));
        look.view.cell = cell;
        const LayerDrawing drawing = look.drawing("half-planes");

        QCOMPARE(drawing.labels.size(), std::size_t(6)); // three positive sides, three negative
        const LayerDrawing::Area triangle{{{25, 24}, {31, 25}, {28, 29}}};
        for (const LayerDrawing::Label &label : drawing.labels) {
            QVERIFY(!contains(triangle, label.place));
            QVERIFY(QRectF(0, 0, look.view.seen.endX, look.view.seen.endY).contains(label.place));
        }
    }

    void oneHalfPlaneIsOneOfThem()
    {
        const Look look(sceneBy("edge-equations", firstTriangle()));
        const LayerDrawing all = look.drawing("half-planes");

        for (std::size_t edge = 0; edge < 3; ++edge) {
            const LayerDrawing one = look.drawing(("half-plane-" + std::to_string(edge)).c_str());
            QCOMPARE(one.areas.size(), std::size_t(1));
            QVERIFY(one.areas.front() == all.areas[edge]);
        }
    }

    void whatAMethodDoesNotComputeIsExactAndSaidToBe()
    {
        const LayerDrawing byColumns
            = Look(sceneBy("column-scan", firstTriangle())).drawing("half-planes");
        const LayerDrawing byEdges
            = Look(sceneBy("edge-equations", firstTriangle())).drawing("half-planes");

        QVERIFY(byColumns.labels == byEdges.labels);
        QCOMPARE(byColumns.notes,
                 QStringList("Half-planes: exact, since “Column scan” computes no edge functions"));
    }

    void theCellsHoldWhatDecidedTheSamplesUpToTheStep_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<QStringList>("ids");
        QTest::newRow("edge functions")
            << QByteArray("edge-equations") << QStringList{"E_0", "E_1", "E_2"};
        QTest::newRow("weights") << QByteArray("barycentric-rectangle")
                                 << QStringList{"alpha", "beta", "gamma"};
        QTest::newRow("Cramer's rule")
            << QByteArray("barycentric-cramer") << QStringList{"u", "v", "w"};
    }
    void theCellsHoldWhatDecidedTheSamplesUpToTheStep()
    {
        QFETCH(QByteArray, method);
        QFETCH(QStringList, ids);
        // (0, 0) (8, 0) (0, 4): at (2, 1) each weight is a multiple of 1/4.
        Look look(sceneBy(method.constData(), triangleAt(0, 0, 8, 0, 0, 4)));
        const ScanTrace &trace = *look.traced->trace;
        const std::size_t middle = trace.spanCount() / 2;
        look.view.position = trace.indexOfSample(trace.firstSampleOf(middle)) + 1;
        const LayerDrawing drawing = look.drawing("weights");

        QCOMPARE(drawing.cells.size(), 3 * (trace.firstSampleOf(middle) + 1));
        QCOMPARE(drawing.cellNames.size(), qsizetype(3));
        const SampleRecord sample = trace.samples(middle).front();
        const NamedNumbers numbers(trace.numbers().sample, sample.cells);
        QStringList expected;
        for (const QString &id : ids) {
            const Quantity number = numbers[id];
            expected.append(number.isInteger() ? toText(number) : toDecimal(number, 2));
        }
        QCOMPARE(textsIn(drawing, sample.x, sample.y).replaceInStrings("−", "-"), expected);
        QVERIFY(textsIn(drawing, 8, 4).isEmpty());
    }

    void weightsThatAMethodDoesNotComputeAreThoseOfBarycentricOnes()
    {
        Look look(sceneBy("column-scan", triangleAt(0, 0, 8, 0, 0, 4)));
        const LayerDrawing exact = look.drawing("weights");

        QCOMPARE(textsIn(exact, 2, 1), QStringList({"0.50", "0.25", "0.25"}));
        QCOMPARE(
            exact.notes,
            QStringList("α, β, γ belong to a, b, c, the vertices 0, 1, 2, and are exact, since "
                        "“Column scan” computes none"));
        QCOMPARE(exact.cellNames, QStringList({"α", "β", "γ"}));

        // As the tool tip shows it: only for samples that the method has visited.
        const ScanTrace &trace = *look.traced->trace;
        QCOMPARE(exact.cells.size(), 3 * trace.sampleCount());
        for (const std::size_t done : {std::size_t(0), trace.sampleCount() / 2}) {
            look.view.position = done == 0 ? 1 : trace.indexOfSample(done - 1) + 1;
            QCOMPARE(look.drawing("weights").cells.size(), 3 * done);
        }
    }

    void levelsAreThoseOfTheSamples()
    {
        const LayerDrawing drawing
            = Look(sceneBy("column-scan", triangleAt(0, 0, 8, 0, 0, 4))).drawing("levels");

        // 255/2 red, 255/4 green, 255/4 blue.
        QCOMPARE(textsIn(drawing, 2, 1), QStringList({"127.5", "63.8", "63.8"}));
    }

    void specialPointsHaveTheirWeights()
    {
        // a, b, c are the scene's, P0, P1, P2 the column scan's, which sorts them.
        const Look look(sceneBy("column-scan", triangleAt(12, 3, 0, 0, 3, 9)));
        const LayerDrawing drawing = look.drawing("barycentric-axes");
        const auto placeOfLabel = [&](const char *text) {
            const auto found = std::ranges::find(drawing.labels, QString::fromUtf8(text),
                                                 &LayerDrawing::Label::text);
            return found == drawing.labels.end() ? QPointF(-99, -99) : found->place;
        };

        QCOMPARE(placeOfLabel("a = P2 (1, 0, 0)"), QPointF(12, 3));
        QCOMPARE(placeOfLabel("b = P0 (0, 1, 0)"), QPointF(0, 0));
        QCOMPARE(placeOfLabel("c = P1 (0, 0, 1)"), QPointF(3, 9));
        QCOMPARE(placeOfLabel("(½, ½, 0)"), QPointF(6, 1.5));
        QCOMPARE(placeOfLabel("(0, ½, ½)"), QPointF(1.5, 4.5));
        QCOMPARE(placeOfLabel("(⅓, ⅓, ⅓)"), QPointF(5, 4));
        // β = 1 goes through b along γ's axis, c − a, from γ = −1 to 2.
        const LayerDrawing::Line line
            = {{9, -6}, {-18, 12}, LayerInk::First, LayerDrawing::Stroke::Dashed};
        QVERIFY(std::ranges::count(drawing.lines, line) == 1);
    }

    void contourLinesAreThoseOfTheChannelsPlane_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::newRow("the vertices' plane") << QByteArray("column-scan");
        QTest::newRow("the set-up's plane") << QByteArray("interpolate-plane");
    }
    void contourLinesAreThoseOfTheChannelsPlane()
    {
        QFETCH(QByteArray, method);
        const LayerDrawing drawing
            = Look(sceneBy(method.constData(), triangleAt(0, 0, 32, 0, 0, 16)))
                  .drawing("isolines-red");

        QCOMPARE(drawing.lines.size(), std::size_t(7)); // 32, 64, … 224
        for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
            // R = 255·(1 − x/32 − y/16)
            for (const QPointF &end : {drawing.lines[i].from, drawing.lines[i].to})
                QVERIFY(std::abs(255 * (1 - end.x() / 32 - end.y() / 16) - 32.0 * double(i + 1))
                        < 1e-9);
        }
        QCOMPARE(drawing.labels.front().text, u"R = 32"_s);
    }

    void missingContourLinesAreExplained_data()
    {
        QTest::addColumn<Triangle>("triangle");
        QTest::addColumn<QString>("note");
        const auto with = [](int a, int b, int c) {
            Triangle triangle = triangleAt(0, 0, 32, 0, 0, 16);
            triangle.vertices[0].colour.channels[0] = std::uint8_t(a);
            triangle.vertices[1].colour.channels[0] = std::uint8_t(b);
            triangle.vertices[2].colour.channels[0] = std::uint8_t(c);
            return triangle;
        };
        QTest::newRow("one level")
            << with(200, 200, 200) << "Contour lines of R: none, R is 200 all over the triangle";
        QTest::newRow("between two levels")
            << with(130, 150, 159)
            << "Contour lines of R: none, from 130 to 159 R meets no multiple of 32";
        QTest::newRow("no area") << triangleAt(0, 0, 4, 4, 8, 8)
                                 << "Contour lines of R: the triangle has no area, so that its "
                                    "levels lie on no plane";
    }
    void missingContourLinesAreExplained()
    {
        QFETCH(Triangle, triangle);
        QFETCH(QString, note);

        const LayerDrawing drawing = Look(sceneBy("column-scan", triangle)).drawing("isolines-red");

        QVERIFY(drawing.lines.empty());
        QCOMPARE(drawing.notes, QStringList(note));
    }

    void specialPointsBesideTheFrameAndEveryAxisHaveTheirNames()
    {
        // b is above the frame, c right of it, and all places in front of a left of it.
        const LayerDrawing drawing = Look(sceneBy("column-scan", triangleAt(2, 5, 30, 48, 64, 3)))
                                         .drawing("barycentric-axes");
        const QStringList names = textsOf(drawing.labels);

        for (const char *name :
             {"a = P0 (1, 0, 0)", "b = P1 (0, 1, 0)", "c = P2 (0, 0, 1)", "β = 0", "γ = 0"})
            QVERIFY2(names.contains(QString::fromUtf8(name)), name);
        const auto axis = std::ranges::find(drawing.labels, u"β = 0"_s, &LayerDrawing::Label::text);
        QVERIFY(QRectF(-0.5, -0.5, 64, 48).contains(axis->place));
        // One colour per line: a name has the colour of its line.
        for (const char *name : {"β = 0", "γ = 0", "β = 1", "γ = 1"}) {
            const auto label = std::ranges::find(drawing.labels, QString::fromUtf8(name),
                                                 &LayerDrawing::Label::text);
            const auto line = std::ranges::find_if(drawing.lines, [&](const auto &each) {
                const QPointF along = each.to - each.from;
                const QPointF way = label->place - each.from;
                return std::abs(along.x() * way.y() - along.y() * way.x()) < 1e-6;
            });
            QVERIFY2(line != drawing.lines.end() && line->ink == label->ink, name);
        }
    }

    void everySampleOfAPixelIsAPoint()
    {
        Scene scene = sceneBy("column-scan", firstTriangle());
        scene.frame.width = 3;
        scene.frame.height = 2;
        QCOMPARE(Look(scene).drawing("samples").samples.size(), std::size_t(6));

        scene.appearance.antialiasing = Antialiasing::Samples4;
        const LayerDrawing drawing = Look(scene).drawing("samples");

        QCOMPARE(drawing.samples.size(), std::size_t(30));
        for (const LayerDrawing::Point &point : drawing.samples) {
            const QPointF away = point.place - QPointF(point.place.toPoint());
            QVERIFY(std::abs(away.x()) < 0.5 && std::abs(away.y()) < 0.5);
        }
    }

    void smallCellsHoldNoNumbersAndSaySo()
    {
        Look look(sceneBy("edge-equations", firstTriangle()));
        look.view.cell = 8;
        const LayerDrawing drawing = look.drawing("weights");

        QVERIFY(drawing.cells.empty());
        QVERIFY(drawing.notes.front().contains("a cell needs 24 pixels"));
    }

    void aNameOfTwoLayersStandsThereOnce()
    {
        const Look look(sceneBy("edge-equations", firstTriangle()));
        const LayerDrawing both = drawingOf({u"half-planes"_s, u"half-plane-1"_s}, look.view);
        QCOMPARE(textsOf(both.labels), textsOf(look.drawing("half-planes").labels));
    }

    void numbersThatAreTooLongForACellSayHowLargeItMustBe()
    {
        Look look(sceneBy("edge-equations", firstTriangle()));
        look.view.cell = 24;
        QImage picture(64 * 24, 48 * 24, QImage::Format_RGB32);
        QPainter painter(&picture);
        LayerDrawing drawing;
        drawing.cells = {{1, 1, u"−1234567.5"_s}};

        QCOMPARE(LayerPainter().paint(painter, drawing, surfaceOf(look, picture)),
                 QStringList("No room for the numbers in the cells: they need cells of 41 pixels; "
                             "enlarge the picture, or show fewer layers"));
        drawing.cells = {{1, 1, u"−123"_s}};
        QVERIFY(LayerPainter().paint(painter, drawing, surfaceOf(look, picture)).isEmpty());
    }

    void namesAvoidEachOtherAndOccupiedPlaces()
    {
        Look look(sceneBy("edge-equations", firstTriangle()));
        look.view.cell = 12;
        QImage picture(64 * 12, 48 * 12, QImage::Format_RGB32);
        QPainter painter(&picture);
        const LayerSurface surface = surfaceOf(look, picture);
        LayerDrawing drawing = look.drawing("vertices");
        const std::array everywhere = {QRectF(picture.rect())};

        QVERIFY(LayerPainter().paintLabels(painter, drawing, surface, {}).isEmpty());
        QCOMPARE(
            LayerPainter().paintLabels(painter, drawing, surface, everywhere),
            QStringList("No room for 3 of 3 names: enlarge the picture, or show fewer layers"));
        // More labels at one place than there are sides and distances.
        drawing.labels.assign(50, drawing.labels.back());
        QCOMPARE(LayerPainter().paintLabels(painter, drawing, surface, {}).size(), qsizetype(1));
    }

    void theCurrentPrimitiveIsTheOneThatIsDrawn()
    {
        Scene scene = sceneBy("edge-equations", triangleAt(0, 0, 8, 0, 0, 4));
        scene.triangles.push_back(triangleAt(10, 10, 20, 10, 10, 20));
        Look look(scene);

        QCOMPARE(textsOf(look.drawing("box").labels).first(), "bbox: x 10 … 20, y 10 … 20");
        look.view.position = 1;
        QCOMPARE(textsOf(look.drawing("box").labels).first(), "bbox: x 0 … 8, y 0 … 4");
        look.view.primitive = 1;
        QCOMPARE(textsOf(look.drawing("box").labels).first(), "bbox: x 10 … 20, y 10 … 20");
    }

    void aLayerWithNothingToShowSaysWhy_data()
    {
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<QString>("layer");
        QTest::addColumn<QString>("objection");
        QTest::newRow("another kind") << QByteArray("line-bresenham") << "weights"
                                      << "“Line: Bresenham” draws no triangle";
        QTest::newRow("not in the scene") << QByteArray("polygon-parity") << "box"
                                          << "the scene has no polygon";
        QTest::newRow("something to show") << QByteArray("row-walk") << "weights"
                                           << "";
    }
    void aLayerWithNothingToShowSaysWhy()
    {
        QFETCH(QByteArray, method);
        QFETCH(QString, layer);
        QFETCH(QString, objection);

        QCOMPARE(layerNamed(layer)->objection(sceneBy(method.constData(), firstTriangle())),
                 objection);
    }

    void everyLayerDrawsAnEmptySceneAndASceneOfNoArea()
    {
        QStringList ids;
        for (const Layer &layer : layers()) {
            QVERIFY2(!layer.toolTip.isEmpty(), qPrintable(layer.id));
            ids.append(layer.id);
        }
        for (const Method &method : methods()) {
            Scene scene;
            scene.method = method.id.toStdString();
            const LayerDrawing ofPixels = drawingOf(ids, Look(scene).view);
            QVERIFY(ofPixels.labels.empty() && ofPixels.lines.empty());
            QCOMPARE(ofPixels.cells.size(), std::size_t(64 * 48)); // addresses
            scene.triangles = {triangleAt(2, 2, 2, 2, 2, 2), triangleAt(-9, 1, -9, 7, -9, 3)};
            drawingOf(ids, Look(scene).view);
        }
    }
};

PIXELPLUMB_TEST(TestLayers)

} // namespace tst_layers

#include "tst_layers.moc"
