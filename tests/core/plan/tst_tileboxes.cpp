// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/tileboxes.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QtTest>

#include <set>

namespace tst_tileboxes {

using namespace pixelplumb;

class TestTileBoxes : public QObject {
    Q_OBJECT

private slots:
    void eachPairOfBoxesThatMeetIsVisitedInOneTile()
    {
        QRandomGenerator random(1);
        for (int scene = 0; scene < 50; ++scene) {
            constexpr std::int32_t side = 4000;
            std::vector<DepthBox> boxes(20 + random.bounded(60));
            for (DepthBox &box : boxes) {
                box.left = std::int32_t(random.bounded(side));
                box.low = std::int32_t(random.bounded(side));
                box.right = std::min(side, box.left + std::int32_t(random.bounded(900)));
                box.high = std::min(side, box.low + std::int32_t(random.bounded(900)));
                box.nearest = std::int32_t(random.bounded(5));
                box.farthest = box.nearest + std::int32_t(random.bounded(3));
            }
            std::vector<bool> inQuestion(boxes.size());
            for (std::size_t i = 0; i < boxes.size(); ++i)
                inQuestion[i] = random.bounded(2) == 0;
            const SettledPairs settled{random.bounded(2) == 0, random.bounded(2) == 0};

            using Pairs = std::multiset<std::pair<std::size_t, std::size_t>>;
            Pairs expected;
            std::int64_t meeting = 0;
            for (std::size_t later = 0; later < boxes.size(); ++later) {
                for (std::size_t earlier = 0; earlier < later; ++earlier) {
                    const DepthBox &a = boxes[earlier];
                    const DepthBox &b = boxes[later];
                    if (a.left > b.right || b.left > a.right || a.low > b.high || b.low > a.high)
                        continue;
                    ++meeting;
                    const bool isSettled = (settled.inOrder && b.farthest <= a.nearest)
                        || (settled.inQuestion && inQuestion[earlier] && inQuestion[later]);
                    if (!isSettled)
                        expected.insert({earlier, later});
                }
            }
            const DepthTiles tiles(boxes, side, side);
            TileBoxes current;
            Pairs visited;
            for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
                const auto places = tiles.placesIn(tile);
                current.take(boxes, places, tiles.cornerOf(tile), inQuestion);
                for (std::size_t later = 0; later < places.size(); ++later)
                    meeting -= current.forEachMeeting(later, settled, [&](std::size_t earlier) {
                        visited.insert({places[earlier], places[later]});
                    });
            }
            QVERIFY(tiles.count() > 1);
            QCOMPARE(meeting, 0);
            QVERIFY(visited == expected);
        }
    }
};

PIXELPLUMB_TEST(TestTileBoxes)

} // namespace tst_tileboxes

#include "tst_tileboxes.moc"
