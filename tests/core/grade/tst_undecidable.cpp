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
};

PIXELPLUMB_TEST(TestUndecidable)

} // namespace tst_undecidable

#include "tst_undecidable.moc"
