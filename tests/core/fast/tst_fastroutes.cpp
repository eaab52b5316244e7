// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "tests/support/guardedframe.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_fastroutes {

using namespace pixelplumb;

/// What the fast path reports about itself: which kernel took a triangle, and why.
class TestFastRoutes : public QObject {
    Q_OBJECT

private slots:
    void startsNoThreadForATriangle()
    {
        GuardedFrame frame({64, 48, 0, 0, 0, RowOrder::Ascending});
        const std::vector<Triangle> scene = {triangleAt(1, 2, 30, 40, 60, 10)};
        QCOMPARE(drawFast(scene, {}, frame.view(), {8, std::nullopt}).threads, 1);
    }

    void saysWhichKernelTookATriangleAndWhy()
    {
        GuardedFrame frame({640, 480, 0, 0, 0, RowOrder::Ascending});
        Triangle small = triangleAt(1, 2, 5, 3, 2, 9);
        small.vertices[0].colour = {{255, 0, 0}};
        const std::vector<Triangle> scene = {small, triangleAt(-9, 2, -5, 3, -2, 9)};
        const FastReport report = drawFast(scene, {}, frame.view(), {1, std::nullopt});
        const std::vector<FastRouteUse> expected
            = {{FastKernel::None, ColourWord::Other, FastReason::OutsideFrame, 1},
               {FastKernel::Block8, ColourWord::Steps32, FastReason::SmallBox, 1}};
        QVERIFY(report.uses == expected);
    }

    void usesEveryKernelThatItHas()
    {
        const auto kernelFor = [](const Triangle &triangle) {
            GuardedFrame frame({1920, 1080, 0, 0, 0, RowOrder::Ascending});
            const FastReport report
                = drawFast(std::span(&triangle, 1), {}, frame.view(), {1, std::nullopt});
            return std::pair(report.uses.at(0).kernel, report.uses.at(0).word);
        };
        const auto flat = [](Triangle triangle) {
            for (Vertex &vertex : triangle.vertices)
                vertex.colour = red;
            return triangle;
        };
        using Kernel = std::pair<FastKernel, ColourWord>;
        QVERIFY(kernelFor(flat(triangleAt(0, 0, 4, 0, 0, 4)))
                == Kernel(FastKernel::Block8, ColourWord::Flat));
        QVERIFY(kernelFor(triangleAt(0, 0, 12, 0, 0, 12))
                == Kernel(FastKernel::Block16, ColourWord::Steps32));
        QVERIFY(kernelFor(triangleAt(0, 0, 12, 0, 0, 60))
                == Kernel(FastKernel::Block16, ColourWord::Steps32));
        QVERIFY(kernelFor(triangleAt(0, 0, 5, 0, 0, 90))
                == Kernel(FastKernel::Strip8, ColourWord::Steps32));
        QVERIFY(kernelFor(triangleAt(0, 0, 9, 0, 0, 90))
                == Kernel(FastKernel::Strip16, ColourWord::Steps32));
        const FastKernel wide = kernelFor(triangleAt(0, 0, 90, 0, 0, 90)).first;
        QVERIFY(wide == FastKernel::Strip32 || wide == FastKernel::Strip16); // depends on the
                                                                             // registers
        QVERIFY(kernelFor(triangleAt(0, 0, 900, 0, 0, 90))
                == Kernel(FastKernel::RowSpans, ColourWord::Table32));
        QVERIFY(kernelFor(triangleAt(0, 0, 1900, 0, 0, 1070)).second == ColourWord::Table32);
        QVERIFY(kernelFor(triangleAtUnits({1, 1}, {400000, 2}, {3, 200000})).second
                == ColourWord::Steps64);
        QVERIFY(kernelFor(triangleAt(0, 0, 100000, 0, 0, 9))
                == Kernel(FastKernel::Plain, ColourWord::Other));
    }

    void countsEveryTriangleOnce()
    {
        GuardedFrame frame({640, 480, 0, 0, 0, RowOrder::Ascending});
        std::vector<Triangle> scene;
        for (int i = 0; i < 77; ++i) // two full batches and part of a third
            scene.push_back(triangleAt(7 * i, 3, 7 * i + i % 9, 4, 7 * i + 2, 3 + 3 * i));
        const FastReport report = drawFast(scene, {}, frame.view(), {1, std::nullopt});
        std::uint64_t triangles = 0;
        for (const FastRouteUse &use : report.uses)
            triangles += use.triangles;
        QCOMPARE(triangles, std::uint64_t(scene.size()));
    }
};

PIXELPLUMB_TEST(TestFastRoutes)

} // namespace tst_fastroutes

#include "tst_fastroutes.moc"
