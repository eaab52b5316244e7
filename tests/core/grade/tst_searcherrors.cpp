// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/grade/gradefolder.h"
#include "tests/support/probescenes.h"
#include "tests/support/shapes.h"
#include "tests/support/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace {

/// How many more large pieces of memory there are, while there is such a limit; < 0: there is none.
std::atomic<int> largePiecesLeft = -1;

constexpr std::size_t largePiece = std::size_t(1) << 15; // bytes: a picture's, no list's

} // namespace

/// Memory that ends, as on a small machine.
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

/// Nothing draws so.
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

} // namespace

/// Searches for defects that end in an error: what else is known stays, and others are graded.
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
        QCOMPARE(nameOf(diagnosis->verdict), QStringLiteral("wrong"));
        QVERIFY(diagnosis->differing > 0);
        QVERIFY(diagnosis->candidates.empty());
        QVERIFY2(diagnosis->failure->contains(QStringLiteral("the twentieth")),
                 qPrintable(*diagnosis->failure));
    }

    void whereverMemoryEndsOthersAreGraded()
    {
        const QTemporaryDir folder;
        Assignment assignment;
        assignment.name = QStringLiteral("Large");
        Scene scene = sceneOf(lineAt(2, 3, 100, 50), "line-dda", {}); // has few defects
        scene.frame.width = scene.frame.height = 120; // 43 200 bytes of colours
        assignment.scenes = {{QStringLiteral("large"), scene}};
        const QString subs = folder.filePath(QStringLiteral("subs"));
        for (const char *name : {"ada", "bob"}) {
            Picture picture = noise(scene.frame);
            picture.colours.back() = {{1, 2, std::uint8_t(name[0])}}; // none is the other's
            picture.covered.back() = 1;
            QVERIFY(QDir().mkpath(subs + u'/' + QLatin1String(name)));
            QVERIFY(imageOf(picture).save(
                QStringLiteral("%1/%2/large.png").arg(subs, QLatin1String(name))));
        }
        int failedSearches = 0;
        int otherErrors = 0;
        // Before the search, a class is read and judged in some hundred pieces.
        for (int pieces = 1; pieces < 1 << 16 && failedSearches < 2; pieces *= 2) {
            const QString results = folder.filePath(QStringLiteral("results-%1").arg(pieces));
            const GradingOrder order{subs, results, QStringLiteral("1"), 1};
            const ProgressListener limiting = [&](const JobProgress &progress) {
                if (progress.done == 0)
                    largePiecesLeft = pieces;
                return true;
            };

            const auto report = gradeFolder(order, assignment, limiting);

            largePiecesLeft = -1;
            if (!report) {
                ++otherErrors;
                QVERIFY2(report.error().message().contains(QStringLiteral("memory")),
                         qPrintable(report.error().message()));
                QVERIFY(QDir(results + "/grades").entryList(QDir::Files).size() >= 1);
                continue;
            }
            QCOMPARE((*report)->submissions.size(), 2U);
            for (const GradedSubmission &each : (*report)->submissions) {
                QCOMPARE(nameOf(each.verdict), QStringLiteral("wrong"));
                failedSearches += each.searchError ? 1 : 0;
            }
        }
        QVERIFY(failedSearches > 0);
        QVERIFY(otherErrors > 0);
    }
};

PIXELPLUMB_TEST(TestSearchErrors)

} // namespace tst_searcherrors

#include "tst_searcherrors.moc"
