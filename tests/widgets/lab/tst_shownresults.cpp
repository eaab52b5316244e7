// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/madestudy.h"
#include "tests/support/testprogram.h"
#include "widgets/lab/labrun.h"

#include <QTest>

namespace tst_shownresults {

using namespace pixelplumb;

namespace {

enum class Times { None, OfFirstFamily };

/// Results of two families, "f" and "g".
SharedResults madeWith(Times times)
{
    auto results = madeResults({{"column-scan:float32", 2, 5000}});
    for (LabRow &row : results->rows) {
        if (times == Times::None)
            row.cost.reset();
    }
    return results;
}

} // namespace

/// What the lab shows while runs start and end.
class TestShownResults : public QObject {
    Q_OBJECT

private slots:
    void theFirstNewsAreShownAtOnce()
    {
        const SharedResults news = madeWith(Times::None);
        ShownResults shown;
        shown.beginRun();

        QVERIFY(shown.takeNews(news, {}));
        QCOMPARE(shown.results(), news);
        QVERIFY(shown.areOfRun());
    }

    void newsTakeThePlaceOfOthersWhenTheyHaveTimes()
    {
        const SharedResults before = madeWith(Times::OfFirstFamily);
        const SharedResults timed = madeWith(Times::OfFirstFamily);
        ShownResults shown;
        shown.replaceBy(before);
        shown.beginRun();

        QVERIFY(!shown.takeNews(madeWith(Times::None), u"f"_s));
        QVERIFY(!shown.takeNews(timed, u"g"_s)); // it has no times for this family yet
        QCOMPARE(shown.results(), before);
        QVERIFY(!shown.areOfRun());
        QVERIFY(shown.takeNews(timed, u"f"_s));
        QCOMPARE(shown.results(), timed);

        const SharedResults further = madeWith(Times::None);
        QVERIFY(shown.takeNews(further, u"g"_s));
        QCOMPARE(shown.results(), further);
    }

    void aFamilyThatTheNewStudyLeavesOutIsNotWaitedFor()
    {
        ShownResults shown;
        shown.replaceBy(madeWith(Times::OfFirstFamily));
        shown.beginRun();

        QVERIFY(shown.takeNews(madeWith(Times::OfFirstFamily), u"mesh"_s));
    }

    void theEndShowsWhatHasTimes()
    {
        const SharedResults before = madeWith(Times::OfFirstFamily);
        const SharedResults timed = madeWith(Times::OfFirstFamily);
        ShownResults shown;
        shown.replaceBy(before);
        shown.beginRun();
        shown.takeNews(madeWith(Times::None), u"g"_s);
        QVERIFY(!shown.endRun());
        QCOMPARE(shown.results(), before);

        shown.beginRun();
        shown.takeNews(timed, u"g"_s);
        QVERIFY(shown.endRun());
        QCOMPARE(shown.results(), timed);
    }
};

PIXELPLUMB_TEST(TestShownResults)

} // namespace tst_shownresults

#include "tst_shownresults.moc"
