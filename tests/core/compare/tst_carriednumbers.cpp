// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/contest.h"
#include "core/runs/explain/pixelhistory.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_carriednumbers {

using namespace pixelplumb;

namespace {

/// The default triangle with u = 0, 1/3, 1 and depths 1/4, 1/2, 3/4; it needs no effect.
Scene carryingScene(Arithmetic arithmetic)
{
    Scene scene = defaultSceneIn(arithmetic);
    scene.method = "interpolate-bilinear";
    scene.attributes.resize(1);
    for (std::size_t i = 0; i < 3; ++i)
        scene.attributes[0].vertices[i].z = Attribute(i + 1) * attributeOne / 4;
    scene.attributes[0].vertices[1].texture[0] = attributeOne / 3;
    scene.attributes[0].vertices[2].texture[0] = attributeOne;
    return scene;
}

QStringList titlesOf(const PixelAttempt &attempt)
{
    QStringList titles;
    for (const PixelAttempt::Carried &number : attempt.carried)
        titles += number.title;
    return titles;
}

Contender contender(const char *method, Arithmetic arithmetic)
{
    return {methodNamed(QString::fromLatin1(method)),
            {arithmetic, FillRule::Closed, ByteRounding::Nearest}};
}

} // namespace

/// Numbers that vertices carry besides colour, and that no picture shows, are reported and compared
/// if present.
class TestCarriedNumbers : public QObject {
    Q_OBJECT

private slots:
    void aPixelsHistoryHasWhatTheInterpolationCarried()
    {
        const auto traced = traceScene(carryingScene(Arithmetic::Float32));
        QVERIFY(!traced->shading());
        const PixelAttempt attempt = pixelHistory(*traced, 27, 19).front();
        QCOMPARE(titlesOf(attempt), (QStringList{"z", "u", "v"}));
        for (const PixelAttempt::Carried &number : attempt.carried) {
            QVERIFY(!number.exact.isNone());
            QVERIFY(std::abs(errorOf(number.used, number.exact)) < 1e-4);
        }
        const auto exact = traceScene(carryingScene(Arithmetic::Exact));
        QCOMPARE(pixelHistory(*exact, 27, 19).front().carried[1].used, attempt.carried[1].exact);
    }

    void aSceneThatHasNoneShowsNone()
    {
        Scene scene = defaultSceneIn(Arithmetic::Float32);
        scene.method = "interpolate-plane";
        QVERIFY(pixelHistory(*traceScene(scene), 27, 19).front().carried.empty());
        // One triangle carries numbers, the other none.
        scene = carryingScene(Arithmetic::Float32);
        scene.triangles.push_back(scene.triangles.front());
        const auto attempts = pixelHistory(*traceScene(scene), 27, 19);
        QVERIFY(!attempts[0].carried.empty());
        QVERIFY(attempts[1].carried.empty());
    }

    void interpolationsAreComparedInWhatTheyCarry()
    {
        const auto contest
            = compareContenders(carryingScene(Arithmetic::Exact),
                                {contender("interpolate-bilinear", Arithmetic::Exact),
                                 contender("interpolate-plane", Arithmetic::Exact),
                                 contender("interpolate-plane", Arithmetic::Float32),
                                 contender("column-scan", Arithmetic::Exact)});
        QCOMPARE(contest->carried.size(), std::size_t(9)); // three pairs, z u v
        for (const CarriedAgreement &each : contest->carried) {
            QVERIFY(each.second < 3); // the column scan carries nothing
            QCOMPARE(each.samples, contest->runs[0].tally.written);
            const bool isRounded = each.second == 2 && each.title != u"v"_s;
            QCOMPARE(each.differing > 0, isRounded);
            QCOMPARE(each.largest > 0, isRounded);
            QVERIFY(each.largest < 1e-4);
        }
    }

    void nothingIsComparedThatTheSceneHasNot()
    {
        const auto contest
            = compareContenders(defaultSceneIn(Arithmetic::Exact),
                                {contender("interpolate-bilinear", Arithmetic::Float32),
                                 contender("interpolate-plane", Arithmetic::Float32)});
        QVERIFY(contest->carried.empty());
    }
};

PIXELPLUMB_TEST(TestCarriedNumbers)

} // namespace tst_carriednumbers

#include "tst_carriednumbers.moc"
