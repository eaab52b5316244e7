// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/edgepixels.h"
#include "core/geometry/seededrandom.h"
#include "tests/support/effectchanges.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_clippingquestion {

using namespace pixelplumb;

/// What lies in the frame, and what beyond it.
class TestClippingQuestion : public QObject {
    Q_OBJECT

private slots:
    /// Against every sample in and around the frame, by products in whole numbers.
    void clippingIsAskedOfTheSamples_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::newRow("1") << Antialiasing::None;
        QTest::newRow("4") << Antialiasing::Samples4;
        QTest::newRow("16") << Antialiasing::Samples16;
    }
    void clippingIsAskedOfTheSamples()
    {
        QFETCH(Antialiasing, antialiasing);
        constexpr std::array<LatticePoint, 1> own = {};
        const std::span<const LatticePoint> pattern = samplePattern(antialiasing);
        const std::span<const LatticePoint> samples
            = pattern.empty() ? std::span<const LatticePoint>(own) : pattern;
        SeededRandom random(27);
        int crossing = 0;
        for (int i = 0; i < 400; ++i) {
            // About the frame's upper right corner, in quarters of a pixel.
            Triangle triangle = plain().triangles[0];
            for (Vertex &vertex : triangle.vertices)
                vertex.position = {random.between(29 * 4, 34 * 4) * unitsPerPixel / 4,
                                   random.between(21 * 4, 26 * 4) * unitsPerPixel / 4};
            if (doubledArea(triangle) == 0)
                continue;
            bool isIn = false, isBeyond = false;
            for (std::int64_t x = 28; x < 36; ++x) {
                for (std::int64_t y = 20; y < 28; ++y) {
                    for (const LatticePoint &sample : samples) {
                        const LatticePoint at
                            = {x * unitsPerPixel + sample.x, y * unitsPerPixel + sample.y};
                        int left = 0, right = 0;
                        for (std::size_t edge = 0; edge < 3; ++edge) {
                            const LatticePoint &a = triangle.vertices[edge].position;
                            const LatticePoint &b = triangle.vertices[(edge + 1) % 3].position;
                            const Lattice side
                                = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
                            left += side >= 0 ? 1 : 0;
                            right += side <= 0 ? 1 : 0;
                        }
                        if (left == 3 || right == 3)
                            (x < 32 && y < 24 ? isIn : isBeyond) = true;
                    }
                }
            }
            Primitives primitives;
            primitives.triangles = {triangle};
            primitives.appearance.antialiasing = antialiasing;
            const Verdict verdict = verdictsOf(primitives)[Effect::Clipping].verdict;
            QVERIFY2((verdict == Verdict::CalledFor) == (isIn && isBeyond),
                     qPrintable(QString::number(i)));
            crossing += isIn && isBeyond ? 1 : 0;
        }
        QVERIFY(crossing > 50 && crossing < 350);
    }

    /// A stroke is ½ px wide to each side, and the frame ends ½ px beyond its samples.
    void aStrokeBesideTheFrameCallsForNothing()
    {
        for (const Antialiasing antialiasing :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            Primitives primitives;
            primitives.shapes = {smoothLine()};
            primitives.appearance.antialiasing = antialiasing;
            for (const int y : {-1, -2, 24, 26}) {
                for (Vertex &vertex : primitives.shapes[0].vertices)
                    vertex.position.y = y * unitsPerPixel;
                QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].reason,
                         QStringLiteral("nothing is drawn in the frame"));
            }
            for (Vertex &vertex : primitives.shapes[0].vertices)
                vertex.position.y = -unitsPerPixel * 3 / 4;
            QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].verdict, Verdict::CalledFor);
        }
    }
};

PIXELPLUMB_TEST(TestClippingQuestion)

} // namespace tst_clippingquestion

#include "tst_clippingquestion.moc"
