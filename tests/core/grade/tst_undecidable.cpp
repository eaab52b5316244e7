// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturediff.h"
#include "core/scan/choicenames.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_undecidable {

using namespace pixelplumb;

/// A right program's rounding is tolerated, and nothing more.
class TestUndecidable : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsNeverWrong_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<Leeway>("leeway");
        for (const char *method :
             {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle"}) {
            for (const Leeway leeway : {Leeway::Rule, Leeway::Edges, Leeway::Once}) {
                const QByteArray name = nameText(nameOf(leeway)).toLatin1();
                QTest::addRow("%s float32 %s", method, name.data())
                    << Arithmetic::Float32 << leeway;
                QTest::addRow("%s float64 %s", method, name.data())
                    << Arithmetic::Float64 << leeway;
            }
        }
    }
    void aRightProgramIsNeverWrong()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(Leeway, leeway);
        const QByteArray method = QByteArray(QTest::currentDataTag()).split(' ').front();
        SeededRandom random(7);
        std::int64_t differing = 0;
        std::int64_t wrong = 0;
        for (int i = 0; i < 100; ++i) {
            Scene scene;
            scene.method = method.toStdString();
            const int side = i % 6 == 0 ? 200 : 48;
            scene.frame.width = side;
            scene.frame.height = side;
            constexpr std::array<Lattice, 3> units = {256, 128, 1};
            const Lattice unit = units[std::size_t(random.between(0, 2))];
            const auto place
                = [&] { return random.between(-20, std::int64_t(side) * 256 / unit + 20) * unit; };
            const auto vertex = [&] { return Vertex{{place(), place()}, random.colour()}; };
            Triangle triangle{{vertex(), vertex(), vertex()}};
            if (i % 5 == 0) // a sliver
                triangle.vertices[2].position
                    = {triangle.vertices[1].position.x + unit, triangle.vertices[1].position.y};
            scene.triangles = {triangle};
            const Picture right = pictureOf(scene);
            scene.settings.arithmetic = arithmetic;
            const Picture found = pictureOf(scene);
            scene.settings.arithmetic = Arithmetic::Exact;
            const auto undecidable = undecidablePixels(scene, right, found, {leeway, arithmetic});
            differing += differingPixels(right, found);
            wrong += differenceOf(right, found, undecidable).differing();
        }
        QCOMPARE(wrong, std::int64_t(0));
        QVERIFY(differing > 0 || arithmetic == Arithmetic::Float64);
    }

    /// Barycentric programs on whole pixels, where nothing rounds but the third weight.
    void aProgramThatSubtractsTheThirdWeightIsNeverWrong()
    {
        SeededRandom random(19);
        std::int64_t differing = 0;
        for (int i = 0; i < 150; ++i) {
            Scene scene;
            const auto vertex = [&] {
                return Vertex{latticePixel(random.between(0, 63), random.between(0, 47)),
                              random.colour()};
            };
            scene.triangles = {{{vertex(), vertex(), vertex()}}};
            if (i % 3 == 0) // a vertical edge
                scene.triangles[0].vertices[1].position.x
                    = scene.triangles[0].vertices[2].position.x;
            if (doubledArea(scene.triangles.front()) == 0)
                continue;
            const Picture right = pictureOf(scene);
            for (std::size_t third = 0; third < 3; ++third) {
                for (const bool isInDoubles : {false, true}) {
                    const Picture found = withThirdWeight(scene, right, third, isInDoubles);
                    const auto open = undecidablePixels(scene, right, found, {Leeway::Rule});
                    differing += differingPixels(right, found);
                    QCOMPARE(differenceOf(right, found, open).differing(), 0);
                }
            }
        }
        QVERIFY2(differing > 500, qPrintable(QString::number(differing)));
    }

    void aColumnThatIsMissingAltogetherIsWrong()
    {
        for (const std::array<int, 5> &each :
             {std::array{11, 12, 58, 7, 40}, std::array{34, 30, 56, 8, 42}}) {
            const auto [x, y, last, bottom, top] = each;
            Scene scene;
            scene.triangles = {{{Vertex{latticePixel(x, y), {{255, 0, 0}}},
                                 Vertex{latticePixel(last, bottom), {{0, 255, 0}}},
                                 Vertex{latticePixel(last, top), {{0, 0, 255}}}}}};
            const Picture right = pictureOf(scene);
            Picture found = right;
            for (int row = bottom; row <= top; ++row) {
                const std::size_t place = right.placeOf(last, int(pictureLine(scene.frame, row)));
                QCOMPARE(int(right.covered[place]), 1);
                found.colours[place] = scene.frame.background;
            }
            coverAllBut(scene.frame.background, found);
            const auto open = undecidablePixels(scene, right, found, {Leeway::Rule});
            // A third weight may lose many of them, but not these.
            const auto wrong = differenceOf(right, found, open).differing();
            QVERIFY2(wrong > 0, qPrintable(u"column %1"_s.arg(last)));
        }
    }

    /// A vertex' span in its row is a point: no proportion of other colours is right there.
    void aVertexHasItsOwnColour()
    {
        Scene scene;
        scene.triangles = {{{{{latticePixel(30, 20), {{255, 0, 0}}},
                              {latticePixel(57, 9), {{0, 255, 0}}},
                              {latticePixel(57, 22), {{0, 0, 255}}}}}}};
        const Picture right = pictureOf(scene);
        const std::size_t vertex = right.placeOf(57, int(pictureLine(scene.frame, 9)));
        QCOMPARE(right.colours[vertex], (Colour{{0, 255, 0}}));
        // A walk may leave the vertex out, but not draw it in another colour.
        for (const Colour &other : {Colour{{0, 3, 0}}, Colour{{0, 0, 255}}, Colour{{85, 85, 85}}}) {
            Picture found = right;
            found.colours[vertex] = other;
            coverAllBut(scene.frame.background, found);
            QCOMPARE(
                differenceOf(right, found, undecidablePixels(scene, right, found, {})).differing(),
                std::int64_t(1));
        }
    }

    void whatIsWrongByAPixelOrALevelStaysWrong()
    {
        Scene scene;
        SeededRandom random(3);
        std::int64_t wrong = 0;
        std::int64_t changed = 0;
        for (int i = 0; i < 50; ++i) {
            const auto vertex = [&] {
                return Vertex{latticePixel(random.between(1, 60), random.between(1, 46)),
                              random.colour()};
            };
            scene.triangles = {{{vertex(), vertex(), vertex()}}};
            if (doubledArea(scene.triangles.front()) == 0)
                continue;
            const Picture right = pictureOf(scene);
            Picture found = right;
            for (std::size_t place = 0; place < found.size(); ++place) {
                if (right.covered[place] != 0)
                    found.colours[place].channels[0] ^= 2;
                else if (place > 0 && right.covered[place - 1] != 0)
                    found.colours[place] = right.colours[place - 1]; // one beyond the right bound
                else
                    continue;
                ++changed;
            }
            coverAllBut(scene.frame.background, found);
            wrong += differenceOf(right, found,
                                  undecidablePixels(scene, right, found, {Leeway::Edges}))
                         .differing();
        }
        QVERIFY(changed > 5000);
        // Only ties, and pixels at the tips, where spans are thin, are undecidable.
        QVERIFY2(wrong * 100 >= changed * 95, qPrintable(QString::number(wrong)));
    }

private:
    /// The right picture without the samples in which `1 - a - b` is below 0: the weight of vertex
    /// `third`, of floats, subtracted as floats or as C subtracts floats from 1.0.
    static Picture withThirdWeight(const Scene &scene, const Picture &right, std::size_t third,
                                   bool isInDoubles)
    {
        const auto &vertices = scene.triangles.front().vertices;
        const auto px = [&](std::size_t i) { return double(vertices[i % 3].position.x) / 256; };
        const auto py = [&](std::size_t i) { return double(vertices[i % 3].position.y) / 256; };
        const auto doubled = [](double ax, double ay, double bx, double by, double cx, double cy) {
            return float((bx - ax) * (cy - ay) - (cx - ax) * (by - ay));
        };
        const float area = doubled(px(0), py(0), px(1), py(1), px(2), py(2));
        Picture found = right;
        for (int y = 0; y < scene.frame.height; ++y) {
            for (int x = 0; x < scene.frame.width; ++x) {
                const auto weight = [&](std::size_t i) { // of vertex i + 2
                    return doubled(px(i), py(i), px(i + 1), py(i + 1), x, y) / area;
                };
                const float a = weight(third + 2);
                const float b = weight(third);
                const bool isLost = isInDoubles ? 1.0 - a - b < 0 : 1.F - a - b < 0;
                if (isLost)
                    found.colours[right.placeOf(x, int(pictureLine(scene.frame, y)))]
                        = scene.frame.background;
            }
        }
        coverAllBut(scene.frame.background, found);
        return found;
    }
};

PIXELPLUMB_TEST(TestUndecidable)

} // namespace tst_undecidable

#include "tst_undecidable.moc"
