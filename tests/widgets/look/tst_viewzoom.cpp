// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/framespec.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/viewratios.h"
#include "widgets/look/viewmapping.h"

#include <QTest>

namespace tst_viewzoom {

using namespace pixelplumb;

namespace {

const FrameSpec upward = frameOf(64, 48);

} // namespace

/// How a view is fitted, zoomed and moved.
class TestViewZoom : public QObject {
    Q_OBJECT

private slots:
    void fitsTheFrameIntoTheView_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<double>("ratio");
        QTest::addColumn<int>("zoom");
        QTest::newRow("limited by height") << 64 << 48 << 1.0 << 8; // 400 / 48 = 8.3
        QTest::newRow("limited by width") << 100 << 10 << 1.0 << 6; // 600 / 100
        QTest::newRow("device pixels count") << 100 << 10 << 2.0 << 12;
        QTest::newRow("tiny frame") << 2 << 2 << 1.0 << 128;
        QTest::newRow("just fits") << 600 << 400 << 1.0 << 1;
        QTest::newRow("one column too many") << 601 << 400 << 1.0 << -2;
        QTest::newRow("large") << 4096 << 4096 << 1.0 << -11; // 4096 / 400 = 10.24
    }
    void fitsTheFrameIntoTheView()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(double, ratio);
        QFETCH(int, zoom);
        const QRectF view(40, 10, 600, 400);

        const ViewMapping mapping = ViewMapping::fitted(frameOf(width, height), view, ratio);

        QCOMPARE(mapping.zoom().number(), zoom);
        const QRect picture = mapping.devicePicture();
        const QRect device = mapping.deviceRect(view);
        QVERIFY(device.contains(picture));
        QVERIFY((picture.center() - device.center()).manhattanLength() <= 2);
    }

    void zoomingKeepsThePixelUnderTheAnchor()
    {
        for (const Ratio &ratio : ratios) {
            ViewMapping mapping(upward, ViewZoom::fromNumber(1), {7, 9}, ratio.devicePixelRatio,
                                ratio.fraction);
            const QPointF anchor = mapping.positionOf(QPoint(41, 17));
            for (int i = 0; i < 20; ++i) {
                mapping = mapping.zoomedAt(anchor, mapping.zoom().nextLarger());
                QCOMPARE(mapping.pixelAt(anchor), std::optional(QPoint(41, 17)));
            }
        }
    }

    void zoomingInAndOutComesBack()
    {
        const ViewMapping start(upward, ViewZoom::fromNumber(8), {7, 9});
        const QPointF anchor(200, 111);
        const ViewMapping there = start.zoomedAt(anchor, ViewZoom::fromNumber(32));
        QCOMPARE(there.zoomedAt(anchor, ViewZoom::fromNumber(8)), start);
    }

    void movingLeavesPartOfTheFrameInView()
    {
        const QRectF view(40, 10, 600, 400);
        const ViewMapping mapping = ViewMapping::fitted(upward, view, 1);
        for (const QPoint &move :
             {QPoint(9999, 0), QPoint(-9999, 0), QPoint(0, 9999), QPoint(0, -9999)}) {
            const ViewMapping moved = mapping.movedBy(move).keptInside(view);
            const QRect visible = moved.devicePicture() & moved.deviceRect(view);
            QVERIFY(visible.width() >= 24 && visible.height() >= 24);
        }
    }

    void zoomStepsVisitEveryRung()
    {
        std::vector<int> up;
        ViewZoom zoom = ViewZoom::fromNumber(-4);
        while (zoom.nextLarger() != zoom) {
            up.push_back(zoom.number());
            zoom = zoom.nextLarger();
        }
        up.push_back(zoom.number());
        std::vector<int> down;
        for (; zoom.number() > -4; zoom = zoom.nextSmaller())
            down.insert(down.begin(), zoom.number());
        down.insert(down.begin(), zoom.number());

        QCOMPARE(up, down);
        const std::vector<int> expected{-4, -3, -2, 1,  2,  3,  4,  5,  6,  8,  10,
                                        12, 16, 20, 24, 32, 40, 48, 64, 96, 128};
        QCOMPARE(up, expected);
    }
};

PIXELPLUMB_TEST(TestViewZoom)

} // namespace tst_viewzoom

#include "tst_viewzoom.moc"
