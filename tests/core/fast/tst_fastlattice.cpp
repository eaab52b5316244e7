// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "core/scan/walks/columndrawing.h"
#include "tests/support/guardedframe.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_fastlattice {

using namespace pixelplumb;

/// The fast path against the plain kernel on every small triangle.
class TestFastLattice : public QObject {
    Q_OBJECT

private slots:
    /// Every triangle with corners on 5 x 5 whole pixels, each in its own cell, at every position
    /// in a cache line.
    void drawsEveryTriangleOfASmallLattice_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<ByteRounding>("rounding");
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
            for (const ByteRounding rounding : allByteRoundings)
                QTest::addRow("%s, %s", nameOf(rule).data(), nameOf(rounding).data())
                    << rule << rounding;
        }
    }
    void drawsEveryTriangleOfASmallLattice()
    {
        QFETCH(FillRule, rule);
        QFETCH(ByteRounding, rounding);
        const WindowSpec window{875, 875, 0, 0, 5, RowOrder::Ascending};
        std::vector<Triangle> scene;
        for (std::int64_t i = 0; i < 25 * 25 * 25; ++i) {
            const std::int64_t left = i % 125 * 7 + 1;
            const std::int64_t low = i / 125 * 7 + 1;
            Triangle triangle = triangleAt(left + i % 5, low + i / 5 % 5, left + i / 25 % 5,
                                           low + i / 125 % 5, left + i / 625 % 5, low + i / 3125);
            if (doubledArea(triangle) == 0) // other triangles of its batch are set up differently
                continue;
            const std::array<std::uint8_t, 4> levels = {0, 255, 1, std::uint8_t(i)};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::size_t mix = std::size_t(i) * 7 + corner * 5;
                triangle.vertices[corner].colour
                    = {{levels[mix % 4], levels[mix / 4 % 4], levels[mix / 16 % 4]}};
            }
            scene.push_back(triangle);
        }
        const ScanSettings settings{Arithmetic::Exact, rule, rounding};
        GuardedFrame plain(window);
        drawColumns(scene, settings, plain.view());
        for (const InstructionSet set : supportedInstructionSets()) {
            GuardedFrame fast(window);
            drawFast(scene, settings, fast.view(), {1, set});
            QVERIFY2(fast == plain, nameOf(set).data());
        }
    }
};

PIXELPLUMB_TEST(TestFastLattice)

} // namespace tst_fastlattice

#include "tst_fastlattice.moc"
