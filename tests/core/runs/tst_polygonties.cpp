// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_polygonties {

using namespace pixelplumb;

namespace {

/// The rows of marks of a kind, of a polygon by parity in a frame of 10 × 8 pixels.
QList<int> rowsMarked(const QByteArray &contour, MarkKind kind)
{
    const QByteArray text = "{ 'pixelplumb': 1, 'frame': { 'width': 10, 'height': 8 }, 'method': "
                            "'polygon-parity', 'primitives': [ { 'polygon': "
        + contour + ", 'fill': 'even-odd', 'color': '#ffffff' } ] }";
    const auto traced = traceScene(readScene(QByteArray(text).replace('\'', '"'))->scene);
    QList<int> rows;
    for (const TraceMark &mark : traced->marks) {
        if (mark.kind == kind)
            rows.append(
                int(traced->trace->placeOf(traced->trace->stepAt(mark.step).span).coordinate));
    }
    std::ranges::sort(rows);
    return rows;
}

} // namespace

/// The rows on which samples lie on a polygon's edges, and those of its vertices, are marked in the
/// timeline.
class TestPolygonTies : public QObject {
    Q_OBJECT

private slots:
    void theRowsWithSamplesOnEdgesAreMarked_data()
    {
        QTest::addColumn<QByteArray>("contour");
        QTest::addColumn<QList<int>>("rows");
        // Both upright sides have a sample on every row; y = 6 is a row of the polygon's own edge.
        QTest::newRow("a rectangle")
            << QByteArray("[[2, 2], [7, 2], [7, 6], [2, 6]]") << QList<int>{3, 4, 5, 6};
        // x = 1/2 + (y − 1/2)/2 is whole on no row, nor is x = 13/2 − (y − 1/2)/2.
        QTest::newRow("between the samples")
            << QByteArray("[['1/2', '1/2'], ['13/2', '1/2'], ['7/2', '13/2']]") << QList<int>{};
        // From (1, 1) to (7, 3): x = 4 at y = 2.
        QTest::newRow("one crossing")
            << QByteArray("[[1, 1], [7, 3], ['3/2', '7/2']]") << QList<int>{2, 3};
        QTest::newRow("beside the frame")
            << QByteArray("[[-5, 2], [-2, 2], [-2, 6], [-5, 6]]") << QList<int>{};
    }
    void theRowsWithSamplesOnEdgesAreMarked()
    {
        QFETCH(QByteArray, contour);
        QFETCH(QList<int>, rows);
        QCOMPARE(rowsMarked(contour, MarkKind::Tie), rows);
    }

    /// Its lowest vertices lie on the row below the first that is scanned.
    void theRowsOfItsVerticesAreMarked()
    {
        QCOMPARE(rowsMarked("[[1, 1], [8, 1], [8, 7], [5, 3], [1, 5]]", MarkKind::PartBegins),
                 (QList<int>{2, 3, 5, 7}));
        const QByteArray cut = "[[1, -9], [8, -9], [8, 90], [5, 3], [1, 50]]";
        QCOMPARE(rowsMarked(cut, MarkKind::PartBegins), QList<int>{3});
    }
};

PIXELPLUMB_TEST(TestPolygonTies)

} // namespace tst_polygonties

#include "tst_polygonties.moc"
