// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"
#include "widgets/model/job.h"

#include <QtTest>

#include <atomic>
#include <thread>

namespace tst_job {

using namespace pixelplumb;
using namespace std::chrono_literals;

namespace {

constexpr int timeout = 60'000; // ms

/// Work that continues until it is told to end, or until the gate is opened.
struct Gate {
    std::shared_ptr<std::atomic<bool>> isOpen = std::make_shared<std::atomic<bool>>(false);

    void open() const { *isOpen = true; }
    /// Waits; returns whether the gate was opened.
    bool passes(const ProgressListener &listener, const JobProgress &progress) const
    {
        while (!*isOpen && listener(progress))
            std::this_thread::sleep_for(1ms);
        return *isOpen;
    }
};

} // namespace

/// Work in the background.
class TestJob : public QObject {
    Q_OBJECT

private slots:
    void newerWorkDropsTheOlderAndBeginsWhenThatHasEnded()
    {
        Job job;
        const Gate gate;
        std::vector<int> taken;
        std::atomic<int> underWay = 0;
        std::atomic<int> mostUnderWay = 0;
        for (int number = 0; number < 4; ++number) {
            job.start(
                [&, number, gate](const ProgressListener &listener) {
                    mostUnderWay = std::max<int>(mostUnderWay, ++underWay);
                    gate.passes(listener, {});
                    --underWay;
                    return number;
                },
                [&taken](int outcome) { taken.push_back(outcome); });
        }
        gate.open();

        QTRY_VERIFY_WITH_TIMEOUT(!job.isRunning(), timeout);
        QCOMPARE(taken, std::vector<int>{3});
        QCOMPARE(int(mostUnderWay), 1);
    }

    /// Qt fills large areas by the threads of its own pool.
    void theWindowPaintsWhileEveryThreadOfThePoolIsBusy()
    {
        const Gate gate;
        const auto waiting = [gate](const ProgressListener &) {
            return gate.passes([](const JobProgress &) { return true; }, {});
        };
        std::vector<std::unique_ptr<Job>> jobs;
        for (int i = 0; i < 2 * jobPool()->maxThreadCount(); ++i)
            jobs.emplace_back(std::make_unique<Job>())->start(waiting, [](bool) {});
        QTRY_COMPARE_WITH_TIMEOUT(jobPool()->activeThreadCount(), jobPool()->maxThreadCount(),
                                  timeout);
        std::thread rescue([gate] {
            for (int i = 0; i < 10'000 && !*gate.isOpen; ++i)
                std::this_thread::sleep_for(1ms);
            gate.open();
        });
        QImage picture(2000, 2000, QImage::Format_ARGB32_Premultiplied);
        QPainter(&picture).fillRect(picture.rect(), QColor(10, 20, 30, 128));
        const bool wasRescued = gate.isOpen->exchange(true);
        rescue.join();
        QVERIFY(!wasRescued);
    }

    void aCancelledJobEndsAtOnceAndItsOutcomeIsDropped()
    {
        Job job;
        QSignalSpy ended(&job, &Job::ended);
        const auto hasEnded = std::make_shared<std::atomic<bool>>(false);
        bool isTaken = false;
        job.start(
            [hasEnded](const ProgressListener &listener) {
                Gate().passes(listener, {});
                *hasEnded = true;
                return 1;
            },
            [&isTaken](int) { isTaken = true; });
        job.cancel();

        QVERIFY(!job.isRunning());
        QCOMPARE(ended.size(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(*hasEnded, timeout);
        QTest::qWait(20);
        QVERIFY(!isTaken);
        QCOMPARE(ended.size(), 1);
    }

    void itTellsThePhaseAndHowFarItIs()
    {
        Job job;
        const Gate gate;
        std::optional<JobProgress> told;
        connect(&job, &Job::progressChanged,
                [&told](const JobProgress &progress) { told = progress; });
        const JobProgress half{JobPhase::Judging, 5, 10};
        job.start(
            [gate, half](const ProgressListener &listener) { return gate.passes(listener, half); },
            [](bool) {});

        QTRY_VERIFY_WITH_TIMEOUT(told, timeout);
        QCOMPARE(*told, half);
        gate.open();
        QTRY_VERIFY_WITH_TIMEOUT(!job.isRunning(), timeout);
    }

    void aJobThatGoesAwayEndsItsWorkWithoutWaiting()
    {
        const auto hasEnded = std::make_shared<std::atomic<bool>>(false);
        bool isTaken = false;
        const Gate gate;
        {
            Job job;
            job.start(
                [hasEnded, gate](const ProgressListener &) {
                    // Work that ignores the listener: only this test can end it.
                    gate.passes([](const JobProgress &) { return true; }, {});
                    *hasEnded = true;
                    return 1;
                },
                [&isTaken](int) { isTaken = true; });
        }
        QVERIFY(!*hasEnded);
        gate.open();
        QTRY_VERIFY_WITH_TIMEOUT(*hasEnded, timeout);
        QTest::qWait(20);
        QVERIFY(!isTaken);
    }

    void anOutcomeThatDoesNotFitIntoMemoryIsADefaultOne()
    {
        Job job;
        std::optional<std::vector<int>> taken;
        job.start([](const ProgressListener &) -> std::vector<int> { throw std::bad_alloc(); },
                  [&taken](const std::vector<int> &outcome) { taken = outcome; });

        QTRY_VERIFY_WITH_TIMEOUT(taken, timeout);
        QVERIFY(taken->empty());
    }

    void jobsThatMeasureTakeTurns()
    {
        Job first(nullptr, measuringPool());
        Job second(nullptr, measuringPool());
        const Gate gate;
        std::atomic<int> underWay = 0;
        std::atomic<int> mostUnderWay = 0;
        QStringList taken;
        const auto work = [&, gate](const ProgressListener &listener) {
            mostUnderWay = std::max<int>(mostUnderWay, ++underWay);
            gate.passes(listener, {});
            --underWay;
            return 1;
        };
        QCOMPARE(measuringNote(), u"Measuring …"_s);
        first.start(work, [&taken](int) { taken += "first"; });
        second.start(work, [&taken](int) { taken += "second"; });
        QTRY_COMPARE_WITH_TIMEOUT(measuringNote(), u"Waiting for another measurement …"_s, timeout);
        QTest::qWait(50);
        QCOMPARE(int(underWay), 1);
        gate.open();

        QTRY_COMPARE_WITH_TIMEOUT(taken, (QStringList{"first", "second"}), timeout);
        QCOMPARE(int(mostUnderWay), 1);
    }

    void newerWorkWaitsForARest()
    {
        Job job;
        job.setRest(200ms);
        QElapsedTimer clock;
        clock.start();
        qint64 begun = 0; // ms
        job.start([](const ProgressListener &listener) { return Gate().passes(listener, {}); },
                  [](bool) {});
        job.start([&](const ProgressListener &) { return begun = clock.elapsed(); }, [](qint64) {});

        QTRY_VERIFY_WITH_TIMEOUT(!job.isRunning(), timeout);
        QVERIFY(begun >= 190);
    }
};

PIXELPLUMB_TEST(TestJob)

} // namespace tst_job

#include "tst_job.moc"
