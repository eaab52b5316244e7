// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/counterexample.h"
#include "core/grade/hunt/invariants.h"
#include "core/methods/method.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_undrawnscenes {

using namespace pixelplumb;

namespace {

PictureSource rightSource() { return sourceOf(Contender{methodNamed(u"column-scan"_s), {}}); }

/// Draws right, but not where two triangles share an edge.
PictureSource failingOnTwo()
{
    return {u"careless"_s, [right = rightSource()](const Scene &scene) {
                if (scene.triangles.size() > 1)
                    return Result<Picture>(InputError{{}, u"gave up"_s, {}});
                return right.draw(scene);
            }};
}

} // namespace

/// A program that draws some scenes and fails on others is told where, and why.
class TestUndrawnScenes : public QObject {
    Q_OBJECT

private slots:
    void theFirstSceneThatCannotBeDrawnIsKept()
    {
        const CounterSearch search = findCounterExample(failingOnTwo(), rightSource(), {}, 1);

        QVERIFY(!search.found);
        QVERIFY(search.compared > 0);
        QVERIFY(search.undrawn > 0);
        QCOMPARE(search.firstUndrawn->scene.triangles.size(), std::size_t(2));
        QCOMPARE(search.firstUndrawn->source, u"careless"_s);
        QCOMPARE(search.firstUndrawn->why.message(), u"gave up"_s);
    }

    void whoDrawsNothingIsNotCalledRight()
    {
        const PictureSource nobody{u"nobody"_s, [](const Scene &) {
                                       return Result<Picture>(InputError{{}, u"is away"_s, {}});
                                   }};
        const Contender right{methodNamed(u"column-scan"_s), {}};
        const Scene conventions;

        const CounterSearch search = findCounterExample(nobody, sourceOf(right), conventions, 1);
        const InvariantReport report = checkInvariants(nobody, conventions, 1, 60);

        QVERIFY(!search.found);
        QCOMPARE(search.compared, 0);
        QCOMPARE(search.undrawn, 100); // and then it is enough
        QCOMPARE(search.firstUndrawn->source, u"nobody"_s);
        QCOMPARE(report.firstUndrawn->why.message(), u"is away"_s);
        QCOMPARE(report.checked, 0);
        QVERIFY(report.undrawn > 10);
    }

    void ofTwoThatDrawAllThereIsNone()
    {
        const CounterSearch search = findCounterExample(rightSource(), rightSource(), {}, 1);
        QCOMPARE(search.undrawn, 0);
        QVERIFY(!search.firstUndrawn);
    }

    void aPairOfWhichOneCannotBeDrawnIsNotChecked()
    {
        const InvariantReport report = checkInvariants(failingOnTwo(), {}, 1, 20);

        QCOMPARE(report.checked, 0);
        QVERIFY(report.undrawn > 0);
        QCOMPARE(report.firstUndrawn->scene.triangles.size(), std::size_t(2));
    }

    void aDefectThatASceneCannotHaveIsDrawnRight()
    {
        Scene scene; // its only triangle turns counter-clockwise
        const auto vertex = [](std::int64_t x, std::int64_t y) {
            return Vertex{latticePixel(x, y), {{255, 0, 0}}};
        };
        scene.triangles = {{{vertex(1, 1), vertex(9, 1), vertex(4, 8)}}};
        const Contender method{methodNamed(u"column-scan"_s), {}};
        const auto drawn = sourceOf(u"culls-clockwise"_s, method).draw(scene);
        QVERIFY(drawn);
        QCOMPARE(*drawn, *rightSource().draw(scene));
        QVERIFY(*sourceOf(u"culls-counter-clockwise"_s, method).draw(scene) != *drawn);
    }
};

PIXELPLUMB_TEST(TestUndrawnScenes)

} // namespace tst_undrawnscenes

#include "tst_undrawnscenes.moc"
