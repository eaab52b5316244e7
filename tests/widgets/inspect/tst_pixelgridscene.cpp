// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "widgets/inspect/pixelgridscene.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QTest>

#include <cmath>

namespace tst_pixelgridscene {

using namespace pixelplumb;

namespace {

ViewMapping cellsAround(const QPoint &centre)
{
    return pixelGridMapping({90, 90}, {}, {9, 9}, centre, FrameOrigin::BottomLeft);
}

} // namespace

/// The contents of the pixel grid's cells, without a widget.
class TestPixelGridScene : public QObject {
    Q_OBJECT

private slots:
    void boundsAreNamedAfterTheCurrentSpanAmongTheCells()
    {
        Playhead playhead;
        DisplayOptions options;
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        playhead.seekToSpan(std::size_t(rowOf(27)));
        const auto boundsAround = [&](const QPoint &picked) {
            const ViewMapping mapping = cellsAround(picked);
            return pixelGridScene(playhead, options, mapping).boundsOf;
        };

        QCOMPARE(boundsAround({27, 20}), u"column 27"_s);
        QCOMPARE(boundsAround({23, 20}),
                 u"column 27"_s); // the last of the visible cells
        QCOMPARE(boundsAround({32, 20}), QString());
    }

    /// Of edges through samples the rule takes some and not others, so that the roundings differ.
    void theRoundingsOfABoundGiveItsSample_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<FrameOrigin>("origin");
        for (const char *id : {"interpolate-plane", "interpolate-bilinear-rows", "column-scan"}) {
            QTest::addRow("%s", id) << QString::fromLatin1(id) << FrameOrigin::BottomLeft;
            QTest::addRow("%s, y down", id) << QString::fromLatin1(id) << FrameOrigin::TopLeft;
        }
    }
    void theRoundingsOfABoundGiveItsSample()
    {
        QFETCH(QString, id);
        QFETCH(FrameOrigin, origin);
        Scene scene;
        scene.frame.width = scene.frame.height = 16;
        scene.frame.origin = origin;
        scene.method = id.toStdString();
        scene.settings.arithmetic = Arithmetic::Float32;
        scene.triangles = {
            Triangle{
                {{{latticePixel(0, 0), {}}, {latticePixel(8, 8), {}}, {latticePixel(12, 0), {}}}}},
            Triangle{{{{latticePixel(0, 15), {}},
                       {latticePixel(8, 9), {}},
                       {latticePixel(12, 15), {}}}}}};
        for (const FillRule rule : methodNamed(id)->fillRules) {
            scene.settings.fillRule = rule;
            Playhead playhead;
            const DisplayOptions options;
            playhead.setTraced(traceScene(scene));
            for (std::size_t i = 0; i < playhead.traced()->trace->spanCount(); ++i) {
                playhead.seekToSpan(i);
                const PixelGridScene shown = pixelGridScene(playhead, options, cellsAround({8, 8}));
                if (shown.span->firstSample >= shown.span->endSample)
                    continue;
                const double lower = shown.span->lower.toDouble();
                const double upper = shown.span->upper.toDouble();
                const auto &[first, last] = shown.roundings;
                const double least
                    = first.startsWith(u'⌈') ? std::ceil(lower) : std::floor(lower) + 1;
                const double greatest
                    = last.startsWith(u'⌊') ? std::floor(upper) : std::ceil(upper) - 1;
                QCOMPARE(double(shown.span->firstSample), least);
                QCOMPARE(double(shown.span->endSample - 1), greatest);
                QCOMPARE(shown.areBoundsExact, id != u"column-scan"_s);
            }
        }
    }

    void aBiasIsPartOfTheRounding()
    {
        Scene scene = defaultSceneIn(Arithmetic::Float64);
        scene.method = "column-scan-bias";
        Playhead playhead;
        playhead.setTraced(traceScene(scene));
        playhead.seekToSpan(std::size_t(rowOf(27)));
        const PixelGridScene shown
            = pixelGridScene(playhead, DisplayOptions(), cellsAround({27, 20}));
        QCOMPARE(shown.roundings[0], u"⌈y_B−β_B⌉"_s);
        QCOMPARE(shown.roundings[1], u"⌊y_T+β_T⌋"_s);
    }

    void candidatesAreTheRowsThatAreNotWrittenYet()
    {
        Playhead playhead;
        DisplayOptions options;
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        const ViewMapping mapping = cellsAround(QPoint(33, 10));
        playhead.seekToSpan(std::size_t(rowOf(33)));
        const SpanRecord column = playhead.traced()->trace->span(std::size_t(rowOf(33)));

        const PixelGridScene entered = pixelGridScene(playhead, options, mapping);
        QCOMPARE(entered.firstCandidate, column.firstDrawn);
        QCOMPARE(entered.endCandidate, column.endDrawn);
        QVERIFY(!entered.currentPixel);

        playhead.step(StepUnit::Sample, StepDirection::Forward);
        const PixelGridScene stepped = pixelGridScene(playhead, options, mapping);
        QCOMPARE(stepped.firstCandidate, column.firstDrawn + 1);
        QCOMPARE(stepped.currentPixel, QPoint(33, int(column.firstDrawn)));
    }

    void differencesAreShownOnceTheyAreDecided()
    {
        // Over a long run, 16.16 loses the edge's last bits and colours other pixels than the
        // truth.
        Scene scene = defaultSceneIn(Arithmetic::Fixed16);
        scene.frame.width = 2048;
        scene.frame.height = 700;
        scene.triangles = {{{vertexAt(0, 0, {{0, 0, 0}}), vertexAt(2047, 0, {{255, 200, 1}}),
                             vertexAt(2047, 683, {{3, 9, 255}})}}};
        Playhead playhead;
        DisplayOptions options;
        playhead.setTraced(traceScene(scene));
        const DifferenceMap &differences = playhead.traced()->differences;
        std::optional<QPoint> wrong;
        for (int x = 0; x < scene.frame.width && !wrong; ++x) {
            for (int y = 0; y < scene.frame.height && !wrong; ++y) {
                if (differences.at(x, y) != Difference::None)
                    wrong = QPoint(x, y);
            }
        }
        QVERIFY(wrong);
        const ViewMapping mapping = cellsAround(*wrong);
        const auto signsThere = [&] {
            for (const GridCell &cell : pixelGridScene(playhead, options, mapping).cells) {
                if (cell.pixel == *wrong)
                    return cell.signs.size();
            }
            return std::size_t(0);
        };

        playhead.seek(playhead.traced()->decidedAt(wrong->x(), wrong->y()) - 1);
        QCOMPARE(signsThere(), std::size_t(0));
        playhead.seek(playhead.traced()->decidedAt(wrong->x(), wrong->y()));
        QCOMPARE(signsThere(), std::size_t(1));
        options.setDifferencesShown(false);
        QCOMPARE(signsThere(), std::size_t(0));
    }

    void tiesAreMarkedWhereASampleLiesOnAnEdge()
    {
        Playhead playhead;
        DisplayOptions options;
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        const ViewMapping mapping = cellsAround(QPoint(4, 5));

        QList<QPoint> ties;
        for (const GridCell &cell : pixelGridScene(playhead, options, mapping).cells) {
            if (std::ranges::find(cell.signs, Sign::Tie) != cell.signs.end())
                ties.append(cell.pixel);
        }

        QCOMPARE(ties, QList<QPoint>{QPoint(4, 5)}); // P0 itself
    }
};

PIXELPLUMB_TEST(TestPixelGridScene)

} // namespace tst_pixelgridscene

#include "tst_pixelgridscene.moc"
