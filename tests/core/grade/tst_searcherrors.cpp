// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefolder.h"
#include "core/grade/diagnose/diagnosis.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace {

/// How many more large allocations succeed before one fails; < 0: no limit.
std::atomic<int> largePiecesLeft = -1;

constexpr std::size_t largePiece = std::size_t(1) << 15; // bytes: larger than a list, smaller than
                                                         // a picture

} // namespace

/// Fails a large allocation, as on a machine with little memory.
void *operator new(std::size_t size)
{
    if (size >= largePiece && largePiecesLeft >= 0 && largePiecesLeft-- == 0) {
        largePiecesLeft = -1;
        throw std::bad_alloc();
    }
    if (void *memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

namespace tst_searcherrors {

using namespace pixelplumb;

namespace {

/// A picture that nothing draws.
Picture noise(const FrameSpec &frame)
{
    Picture picture = emptyPicture(frame);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        picture.covered[i] = i % 3 == 0 ? 1 : 0;
        if (picture.covered[i] != 0)
            picture.colours[i] = {{std::uint8_t(17 * i), std::uint8_t(91 * i), 7}};
    }
    return picture;
}

/// An assignment with one scene, whose picture is a large allocation.
Assignment ofALargePicture()
{
    Scene scene = sceneOf(lineAt(2, 3, 100, 50), "line-dda", {}); // a line has few defects
    scene.frame.width = scene.frame.height = 120; // 43 200 bytes of colours
    Assignment assignment;
    assignment.scenes = {{u"large"_s, scene}};
    return assignment;
}

} // namespace

/// Searches and gradings that end in an error: other results remain, and the other submissions are
/// graded.
class TestSearchErrors : public QObject {
    Q_OBJECT

private slots:
    void aSearchThatEndsInAnErrorLeavesTheVerdict()
    {
        const Scene scene = probeScenes().back();
        const Submission submission{scene, noise(scene.frame)};
        const ProgressListener failing = [](const JobProgress &progress) -> bool {
            if (progress.done > 20)
                throw std::runtime_error("the twentieth failed");
            return true;
        };

        const auto diagnosis = diagnose(std::span(&submission, 1), failing);

        QVERIFY(diagnosis);
        QCOMPARE(nameOf(diagnosis->verdict), u"wrong"_s);
        QVERIFY(diagnosis->differing > 0);
        QVERIFY(diagnosis->candidates.empty());
        QVERIFY2(diagnosis->failure->contains(u"the twentieth"_s), qPrintable(*diagnosis->failure));
    }

    void whereverMemoryEndsOthersAreGraded()
    {
        const QTemporaryDir folder;
        Assignment assignment = ofALargePicture();
        assignment.name = u"Large"_s;
        const Scene &scene = assignment.scenes[0].scene;
        const QString subs = folder.filePath(u"subs"_s);
        for (const char *name : {"ada", "bob"}) {
            Picture picture = noise(scene.frame);
            picture.colours.back() = {{1, 2, std::uint8_t(name[0])}}; // all different
            picture.covered.back() = 1;
            QVERIFY(QDir().mkpath(subs + u'/' + QLatin1String(name)));
            QVERIFY(imageOf(picture).save(u"%1/%2/large.png"_s.arg(subs, QLatin1String(name))));
        }
        int failedSearches = 0;
        int ungraded = 0;
        // Before the search, reading and judging a class makes some hundred allocations.
        for (int pieces = 1; pieces < 1 << 16 && failedSearches < 2; pieces *= 2) {
            const QString results = folder.filePath(u"results-%1"_s.arg(pieces));
            const GradingOrder order{subs, results, u"1"_s, 1};
            const ProgressListener limiting = [&](const JobProgress &progress) {
                if (progress.done == 0)
                    largePiecesLeft = pieces;
                return true;
            };

            const auto report = gradeFolder(order, assignment, limiting);

            largePiecesLeft = -1;
            QVERIFY2(report.isOk(), report ? "" : qPrintable(report.error().message()));
            QCOMPARE((*report)->submissions.size(), 2U);
            QVERIFY(QFile::exists(results + u"/grades.csv"_s));
            for (const GradedSubmission &each : (*report)->submissions) {
                QCOMPARE(nameOf(each.verdict), each.gradingError ? u"nothing"_s : u"wrong"_s);
                failedSearches += each.searchError ? 1 : 0;
                ungraded += each.gradingError ? 1 : 0;
            }
        }
        QVERIFY(failedSearches > 0);
        QVERIFY(ungraded > 0);
    }

    void whatCannotBeGradedHasThatAsItsVerdictUntilItCan()
    {
        const QTemporaryDir folder;
        const Assignment assignment = ofALargePicture();
        const QString subs = folder.filePath(u"subs"_s);
        for (const char *name : {"ada", "bob"}) {
            QVERIFY(QDir().mkpath(subs + u'/' + QLatin1String(name)));
            QVERIFY(imageOf(pictureOf(assignment.scenes[0].scene))
                        .save(u"%1/%2/large.png"_s.arg(subs, QLatin1String(name))));
        }
        const QString results = folder.filePath(u"results"_s);
        const GradingOrder order{subs, results, u"1"_s, 1};
        const ProgressListener atOnce = [](const JobProgress &progress) {
            if (progress.done == 0)
                largePiecesLeft = 0; // during ada's search
            return true;
        };

        const auto report = gradeFolder(order, assignment, atOnce);

        largePiecesLeft = -1;
        QVERIFY2(report.isOk(), report ? "" : qPrintable(report.error().message()));
        const QString told = u"cannot be graded: it does not fit into memory"_s;
        const GradedSubmission &ada = (*report)->submissions[0];
        QCOMPARE(verdictText(ada), u"cannot be graded"_s);
        QCOMPARE(ada.points(), 0.0);
        QCOMPARE(sentencesFor(ada, HintLevel::Class), QStringList(u"large: "_s + told));
        QCOMPARE(verdictText((*report)->submissions[1]), u"right"_s);
        QCOMPARE(ungradedLines(**report), QStringList(u"ada: "_s + told));
        QVERIFY(contentOf(results + u"/grades.csv"_s).contains(told.toUtf8()));
        for (const char *file : {"results.json", "index.html", "junit.xml"})
            QVERIFY(contentOf(results + u'/' + QLatin1String(file)).contains(told.toUtf8()));
        QVERIFY(std::ranges::any_of(clustersOf(**report), [&](const GradeCluster &cluster) {
            return cluster.title == told;
        }));

        const auto again = gradeFolder(order, assignment);

        QVERIFY(again.isOk());
        QCOMPARE(verdictText((*again)->submissions[0]), u"right"_s);
        QVERIFY(ungradedLines(**again).isEmpty());
    }

    void aSubmissionThatFailedInParallelIsGradedAgainAlone()
    {
        const QTemporaryDir folder;
        const Assignment assignment = ofALargePicture();
        const QString subs = folder.filePath(u"subs"_s);
        QVERIFY(QDir().mkpath(subs + u"/ada"_s));
        QVERIFY(imageOf(pictureOf(assignment.scenes[0].scene)).save(subs + u"/ada/large.png"_s));
        bool hasFailed = false;
        const ProgressListener once = [&hasFailed](const JobProgress &progress) {
            if (progress.done == 0)
                largePiecesLeft = 0;
            hasFailed = progress.done > 0 && largePiecesLeft < 0;
            return true;
        };

        const auto report
            = gradeFolder({subs, folder.filePath(u"results"_s), u"1"_s, 2}, assignment, once);

        QVERIFY(report.isOk());
        QVERIFY(hasFailed);
        QCOMPARE(verdictText((*report)->submissions[0]), u"right"_s);
    }
};

PIXELPLUMB_TEST(TestSearchErrors)

} // namespace tst_searcherrors

#include "tst_searcherrors.moc"
