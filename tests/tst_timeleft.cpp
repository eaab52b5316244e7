// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/studystages.h"
#include "core/measure/timeleft.h"

#include <QTest>

using namespace pixelplumb;
using namespace std::chrono_literals;

/// How far a job of several stages is.
class TestTimeLeft : public QObject {
    Q_OBJECT

private slots:
    void beforeTheFirstWordItIsWhatIsKnownBefore()
    {
        const TimeLeft left({{JobPhase::Judging, 8}, {JobPhase::Measuring, 6}});

        QCOMPARE(left.share(), 0.0);
        QCOMPARE(left.seconds(), 14.0);
        QCOMPARE(left.text(), QStringLiteral("waiting: 0 %, about 14 s left"));
    }

    void sharesAndTimesAreOfTheWholeJob()
    {
        TimeLeft left({{JobPhase::Judging, 8}, {JobPhase::Measuring, 6}, {JobPhase::Measuring, 2}});
        left.tell({JobPhase::Judging, 0, 100}, m_begin);
        left.tell({JobPhase::Judging, 50, 100}, m_begin + 4s);
        QCOMPARE(left.share(), 0.25);
        QCOMPARE(left.seconds(), 12.0);
        QCOMPARE(left.text(), QStringLiteral("judging: 25 %, about 12 s left"));

        left.tell({JobPhase::Measuring, 30, 60}, m_begin + 11s);
        QCOMPARE(left.share(), 11.0 / 16);
        left.tell({JobPhase::Measuring, 60, 60}, m_begin + 14s);
        left.tell({JobPhase::Measuring, 0, 9}, m_begin + 14s); // it counts from the start: the next
        QCOMPARE(left.share(), 14.0 / 16);
        left.tell({JobPhase::Measuring, 9, 9}, m_begin + 16s);
        QCOMPARE(left.share(), 1.0);
        QCOMPARE(left.seconds(), 0.0);
    }

    void aSlowMachineIsToldFromWhatItDid()
    {
        TimeLeft left({{JobPhase::Judging, 50}, {JobPhase::Measuring, 50}});
        left.tell({JobPhase::Judging, 0, 10}, m_begin);
        left.tell({JobPhase::Judging, 10, 10}, m_begin + 154s); // 50 expected, and 2 of trust

        QCOMPARE(left.seconds(), 50 * (154.0 + 2) / (50 + 2));
        QCOMPARE(left.text(), QStringLiteral("judging: 50 %, about 3 min left"));
    }

    void phasesThatNobodyExpectsChangeNothing()
    {
        TimeLeft left({{JobPhase::Judging, 5}, {JobPhase::Measuring, 5}});
        left.tell({JobPhase::Measuring, 1, 2}, m_begin);
        left.tell({JobPhase::Judging, 1, 2}, m_begin + 1s); // its stage is over
        left.tell({JobPhase::Writing, 1, 2}, m_begin + 1s);

        QCOMPARE(left.share(), 0.75);
    }

    void aStudyTakesLongerTheMoreIsAsked()
    {
        const auto secondsOf
            = [](const StudySettings &settings) { return TimeLeft(stagesOf(settings)).seconds(); };
        StudySettings quick;
        StudySettings full;
        full.extent = StudyExtent::Full;
        StudySettings few;
        few.families = {QStringLiteral("ties")};
        StudySettings untimed;
        untimed.rounds = 0;
        StudySettings longer;
        longer.rounds = 50;

        QVERIFY(secondsOf(quick) > 5 && secondsOf(quick) < 20); // what the manual promises
        QVERIFY(secondsOf(full) > 60 && secondsOf(full) < 300);
        QVERIFY(secondsOf(few) < secondsOf(quick) / 5);
        QVERIFY(secondsOf(untimed) < secondsOf(quick));
        QVERIFY(secondsOf(longer) > 2 * secondsOf(quick));
        QCOMPARE(stagesOf(untimed).size(), std::size_t(1));
    }

private:
    TimeLeft::Clock::time_point m_begin;
};

QTEST_APPLESS_MAIN(TestTimeLeft)
#include "tst_timeleft.moc"
