// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefolder.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QTemporaryDir>
#include <QTest>

#include <numeric>

namespace tst_gradeclass {

using namespace pixelplumb;

namespace {

/// What is submitted besides the defects.
enum class Spoilt { No, OnePixel, NoPicture };

Spoilt spoiltAt(std::size_t place)
{
    if (place % 20 == 3)
        return Spoilt::NoPicture;
    return place % 10 == 4 ? Spoilt::OnePixel : Spoilt::No;
}

/// The defects of a submission: first each alone, then pairs.
std::vector<Defect> defectsAt(std::size_t place, const std::vector<Defect> &all)
{
    const Defect &one = all[place % all.size()];
    const Defect &other = all[(7 * place + 11) % all.size()];
    if (place >= all.size() && one.id != other.id && canBeTogether(one, other))
        return {one, other};
    return {one};
}

} // namespace

/// A class of 200: single defects, pairs, inexplicable pictures, and files that are no picture.
class TestGradeClass : public QObject {
    Q_OBJECT

private slots:
    void aWholeClassIsGraded()
    {
        const QTemporaryDir folder;
        const Assignment assignment = exampleAssignment();
        const std::vector<Defect> defects = defectsOf(assignment);
        std::vector<std::size_t> all(200);
        std::iota(all.begin(), all.end(), 0U);
        const auto kindOf = [&](std::size_t place) {
            return u"%1 %2"_s.arg(int(spoiltAt(place))).arg(defectsAt(place, defects).size());
        };
        const std::vector<std::size_t> places = casesToRun(all, kindOf);
        std::size_t explicable = 0;
        for (const std::size_t place : places) {
            const QString own = folder.filePath(u"subs/%1"_s.arg(place, 3, 10, QLatin1Char('0')));
            QVERIFY(deliver(own, assignment, defectsAt(place, defects)));
            const QString first = u"%1/%2.png"_s.arg(own, assignment.scenes.front().name);
            switch (spoiltAt(place)) {
            case Spoilt::No:
                ++explicable;
                break;
            case Spoilt::OnePixel: { // a pixel that no program would write
                QImage image(first);
                image.setPixel(int(place % 40), 1, qRgb(1, 2, 3));
                QVERIFY(image.save(first));
                break;
            }
            case Spoilt::NoPicture:
                QVERIFY(writeTo(first, QByteArray::number(qulonglong(place))));
            }
        }

        const auto report = gradeFolder(
            {folder.filePath(u"subs"_s), folder.filePath(u"results"_s), u"1"_s, 2}, assignment);
        QVERIFY(report.isOk() && report->has_value());
        QCOMPARE((*report)->submissions.size(), places.size());
        std::size_t explained = 0;
        for (const GradedSubmission &each : (*report)->submissions)
            explained += each.verdict == GradeVerdict::Right || each.isExplained() ? 1 : 0;
        // A small random sample may explain fewer.
        const std::size_t percent = areAllCasesRun() ? 90 : 75;
        QVERIFY(100 * explained >= percent * explicable);
    }
};

PIXELPLUMB_TEST(TestGradeClass)

} // namespace tst_gradeclass

#include "tst_gradeclass.moc"
