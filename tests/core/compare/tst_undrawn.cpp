// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/contest.h"
#include "core/methods/stroketruth.h"
#include "core/runs/undrawn.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_undrawn {

using namespace pixelplumb;

namespace {

Contender truth(FillRule rule)
{
    return {nullptr, {Arithmetic::Exact, rule, ByteRounding::Nearest}};
}

} // namespace

/// What a comparison says about primitives of a kind that a method does not draw.
class TestUndrawn : public QObject {
    Q_OBJECT

private slots:
    void everyDifferenceFromTheTruthIsCounted_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void everyDifferenceFromTheTruthIsCounted()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        // Where it has a truth of its own, it parts from the scene's.
        const bool isOwn = strokeTruthOf(&method) == oracle::StrokeTruth::PixelWide;
        for (const auto &[name, scene] : scenesForEveryMethod()) {
            const Contender contender = contenderFor(method, scene.settings);
            const auto contest
                = compareContenders(scene, {contender, truth(contender.settings.fillRule)});
            const ContenderRun &run = contest->runs.front();
            QCOMPARE(run.wholeTruth.has_value(),
                     !kindsUndrawn(contest->primitives, method).isEmpty());
            const FrameView frame = run.picture.view();
            std::int64_t undrawn = 0;
            for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
                for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
                    undrawn += run.isUndrawn(x, y) ? 1 : 0;
                    if (*frame.at(x, y) == *contest->runs[1].picture.view().at(x, y))
                        continue;
                    const QString place = u"%1 (%2, %3)"_s.arg(name).arg(x).arg(y);
                    QVERIFY2(isOwn || run.isUndrawn(x, y)
                                 || differenceAt(contest->judged(0), x, y) != Difference::None,
                             qPrintable(place));
                    QVERIFY2(contest->agreement.reasonAt(x, y) != Disagreement::TieRule,
                             qPrintable(place));
                }
            }
            QCOMPARE(run.tally.undrawn, undrawn);
            const std::int64_t counted = run.tally.againstTruth.total() + run.tally.undrawn;
            QVERIFY2(isOwn || run.tally.differsFrom[1] <= counted, qPrintable(name));
            QVERIFY2(!isOwn || run.tally.againstTruth.total() == 0, qPrintable(name));
        }
    }

    void namesTheKindThatAMethodPassesOver()
    {
        Scene scene;
        scene.triangles.resize(1);
        const std::array corners = {latticePixel(2, 2), latticePixel(20, 4), latticePixel(9, 20)};
        for (std::size_t i = 0; i < 3; ++i)
            scene.triangles.front().vertices[i].position = corners[i];
        scene.shapes.push_back({PrimitiveKind::Point,
                                {{latticePixel(40, 40), {{255, 255, 255}}}},
                                {},
                                ShapeFill::Outline,
                                {},
                                0});

        const auto contest = compareContenders(
            scene, {contenderFor(*methodNamed(u"column-scan"), {}), truth(FillRule::Closed)});

        QCOMPARE(contest->agreement.differing(), 1);
        QCOMPARE(contest->agreement.reasonAt(40, 40), Disagreement::Undrawn);
        QCOMPARE(contest->runs[0].tally.undrawn, 1);
        QCOMPARE(comparePixel(*contest, 40, 40).opinions[0].words,
                 u"column-scan does not draw point 1, which stands here."_s);
    }
};

PIXELPLUMB_TEST(TestUndrawn)

} // namespace tst_undrawn

#include "tst_undrawn.moc"
