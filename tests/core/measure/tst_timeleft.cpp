// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/study.h"
#include "core/measure/timeleft.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_timeleft {

using namespace pixelplumb;
using namespace std::chrono_literals;

/// The progress of a long job.
class TestTimeLeft : public QObject {
    Q_OBJECT

private slots:
    void beforeAnyReportTheEstimateIsUsed()
    {
        const TimeLeft left(14);

        QCOMPARE(left.share(), 0.0);
        QCOMPARE(left.seconds(), 14.0);
        QCOMPARE(left.text(), u"waiting: 0 %, about 14 s left"_s);
    }

    void whatIsLeftIsOfTheWholeJob()
    {
        TimeLeft left(16);
        left.tell({JobPhase::Judging, 0, 100}, m_begin);
        left.tell({JobPhase::Judging, 25, 100}, m_begin + 4s);
        QCOMPARE(left.share(), 0.25);
        QCOMPARE(left.seconds(), 12.0);
        QCOMPARE(left.text(), u"judging: 25 %, about 12 s left"_s);

        left.tell({JobPhase::Measuring, 100, 100}, m_begin + 16s);
        QCOMPARE(left.share(), 1.0);
        QCOMPARE(left.seconds(), 0.0);
    }

    void aSlowMachineIsToldFromWhatItDid()
    {
        TimeLeft left(100);
        left.tell({JobPhase::Judging, 0, 20}, m_begin);
        left.tell({JobPhase::Judging, 10, 20}, m_begin + 154s); // 50 s expected, plus 2 of trust

        QCOMPARE(left.seconds(), 50 * (154.0 + 2) / (50 + 2));
        QCOMPARE(left.text(), u"judging: 50 %, about 3 min left"_s);
    }

    void aJobOfUnknownSizeShowsNoProgress()
    {
        TimeLeft left(10);
        left.tell({JobPhase::Reading, 7, 0}, m_begin);

        QCOMPARE(left.share(), 0.0);
    }

    void aStudyTakesLongerTheMoreIsAsked()
    {
        StudySettings quick;
        StudySettings full;
        full.extent = StudyExtent::Full;
        StudySettings few;
        few.families = {u"ties"_s};
        StudySettings untimed;
        untimed.rounds = 0;
        StudySettings longer;
        longer.rounds = 50;

        QVERIFY(expectedSeconds(quick) > 5
                && expectedSeconds(quick) < 20); // as the manual promises
        QVERIFY(expectedSeconds(full) > 60 && expectedSeconds(full) < 300);
        QVERIFY(expectedSeconds(few) < expectedSeconds(quick) / 5);
        QVERIFY(expectedSeconds(untimed) < expectedSeconds(quick));
        QVERIFY(expectedSeconds(longer) > 2 * expectedSeconds(quick));
    }

private:
    TimeLeft::Clock::time_point m_begin;
};

PIXELPLUMB_TEST(TestTimeLeft)

} // namespace tst_timeleft

#include "tst_timeleft.moc"
