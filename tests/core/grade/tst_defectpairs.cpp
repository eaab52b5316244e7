// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/mistakenprograms.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace tst_defectpairs {

using namespace pixelplumb;

namespace {

QStringList idsOf(const Diagnosis &diagnosis)
{
    QStringList ids;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates)
        ids += candidate.ids().join(u" and "_s);
    return ids;
}

std::vector<Defect> redrawingsOf(const Scene &scene)
{
    std::vector<Defect> defects = defectsFor(scene);
    std::erase_if(defects, [](const Defect &defect) { return !defect.redrawing; });
    return defects;
}

Defect defectNamed(const Scene &scene, const QString &id)
{
    const std::vector<Defect> all = defectsFor(scene);
    const auto found = std::ranges::find(all, id, &Defect::id);
    return found != all.end() ? *found : Defect{};
}

} // namespace

/// Two defects that no kernel draws, in one program.
class TestDefectPairs : public QObject {
    Q_OBJECT

private slots:
    void aProgramWithTwoMistakesIsNamed_data()
    {
        QTest::addColumn<WalkLines>("lines");
        QTest::addColumn<QStringList>("mistakes");
        QTest::addColumn<QString>("ids");
        struct Program {
            WalkLines lines;
            QStringList mistakes;
            const char *ids;
        };
        std::vector<Program> programs;
        for (const WalkLines lines : {WalkLines::Columns, WalkLines::Rows}) {
            const bool isColumns = lines == WalkLines::Columns; // rows go from above
            programs.push_back({lines,
                                {"colour-divisor-plus-one", "last-span-missing"},
                                isColumns ? "colour-divisor-plus-one and last-span-missing"
                                          : "colour-divisor-plus-one and first-span-missing"});
            programs.push_back({lines,
                                {"whole-slopes", "colour-divisor-plus-one"},
                                "colour-divisor-plus-one and whole-slopes"});
            programs.push_back({lines,
                                {"whole-edge-colours", "colours-between-samples"},
                                "colours-between-samples and whole-edge-colours"});
            programs.push_back(
                {lines,
                 {"colours-without-edge-pre-step", "second-half-missing"},
                 isColumns ? "colours-without-edge-pre-step and second-half-missing"
                           : "colours-without-edge-pre-step and first-half-and-middle-missing"});
        }
        const auto walkOf = [](const Program &program) {
            return program.lines == WalkLines::Rows ? u"rows"_s : u"columns"_s;
        };
        for (const Program &program : casesToRun(programs, walkOf))
            QTest::addRow("%s, %s", program.ids, qPrintable(walkOf(program)))
                << program.lines << program.mistakes << QString::fromLatin1(program.ids);
    }
    void aProgramWithTwoMistakesIsNamed()
    {
        QFETCH(WalkLines, lines);
        QFETCH(QStringList, mistakes);
        QFETCH(QString, ids);
        const std::vector<Scene> scenes
            = probeScenes(lines == WalkLines::Rows ? "row-walk" : "column-scan");
        const auto submissionsIn = [&](WalkNumbers numbers) {
            const std::vector<Picture> pictures = studentPictures(scenes, lines, mistakes, numbers);
            std::vector<Submission> submissions;
            for (std::size_t i = 0; i < pictures.size(); ++i)
                submissions.push_back({scenes[i], pictures[i]});
            return submissions;
        };
        const auto exact = submissionsIn(WalkNumbers::Fraction);
        const auto rounded = submissionsIn(WalkNumbers::Double);
        for (const auto &submissions : {exact, rounded}) {
            const auto diagnosis = diagnose(submissions);
            QVERIFY2(diagnosis->isExplained(), qPrintable(idsOf(*diagnosis).join(u'\n')));
            QVERIFY2(idsOf(*diagnosis).contains(ids), qPrintable(idsOf(*diagnosis).join(u'\n')));
            QVERIFY(
                partingStepOf(submissions.front().scene, diagnosis->candidates.front().defects));
        }
    }

    void theOrderOfEqualVerticesIsNoThirdMistake()
    {
        std::vector<Submission> submissions;
        std::vector<Scene> scenes = probeSheet(u"column-scan"_s);
        // One triangle's last two vertices share a column, the upper one given first.
        scenes.push_back(scenes.front());
        scenes.back().triangles = {triangleAt(3, 9, 30, 25, 30, 4)};
        const std::vector<Picture> pictures
            = studentPictures(scenes, WalkLines::Columns,
                              {"divisor-plus-one", "colour-divisor-plus-one", "equal-as-given"});
        for (std::size_t i = 0; i < pictures.size(); ++i)
            submissions.push_back({scenes[i], pictures[i]});
        const auto diagnosis = diagnose(submissions);
        QVERIFY2(diagnosis->isExplained(), qPrintable(idsOf(*diagnosis).join(u'\n')));
        const DiagnosisCandidate &named = diagnosis->candidates.front();
        QVERIFY(named.ids().contains(u"divisor-plus-one"_s));
        QVERIFY(named.ids().contains(u"colour-divisor-plus-one"_s));
        QCOMPARE(named.rightAlone(), QStringList{u"equal-as-given"_s});
    }

    void twoThatDecideTheSameAreNotTogether_data()
    {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<bool>("can");
        const auto row = [](const char *one, const char *other, bool can) {
            QTest::addRow("%s, %s", one, other)
                << QString::fromLatin1(one) << QString::fromLatin1(other) << can;
        };
        row("ends-nearest", "ends-upward", false);
        row("whole-slopes", "floor-slopes", false);
        row("whole-slopes", "whole-slopes-from-below", false);
        row("whole-slopes", "whole-edge-colours-from-below", false);
        row("whole-slopes-from-below", "whole-edge-colours-from-below", true);
        row("ends-nearest", "whole-slopes-from-below", true);
        row("divisor-plus-one-from-below", "divisor-minus-one-from-below", false);
        row("divisor-plus-one-from-below", "unsorted-colours-from-below", true);
        row("levels-times-254", "whole-slopes", false); // a walk rounds its own levels
        row("levels-times-254", "levels-times-256", false);
        row("levels-times-254", "last-sample-missing", true);
        row("rounding-truncate", "levels-times-256", false);
        row("rounding-truncate", "levels-times-254", true);
        row("last-sample-missing", "first-sample-missing", true);
        row("parity", "ends-nearest", true);
    }
    void twoThatDecideTheSameAreNotTogether()
    {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(bool, can);
        const Scene scene = probeScenes("row-walk").front();
        const Defect first = defectNamed(scene, one);
        const Defect second = defectNamed(scene, other);
        QCOMPARE(first.id, one);
        QCOMPARE(second.id, other);
        QCOMPARE(canBeTogether(first, second), can);
        QCOMPARE(canBeTogether(second, first), can);
    }

    void theOrderOfTwoDoesNotMatter()
    {
        const std::vector<Scene> scenes = probeScenes();
        const std::vector<Defect> all = redrawingsOf(scenes.front());
        std::vector<std::array<Defect, 2>> pairs;
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = i + 1; j < all.size(); j += 5) {
                if (canBeTogether(all[i], all[j]))
                    pairs.push_back({all[i], all[j]});
            }
        }
        QVERIFY(pairs.size() > all.size());
        for (const auto &[one, other] : casesToRun(pairs))
            QVERIFY2(pictureWith(scenes.back(), std::array{one, other})
                         == pictureWith(scenes.back(), std::array{other, one}),
                     qPrintable(one.id + u' ' + other.id));
    }

    void twoRedrawingsTogetherAreNamed_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"column-scan", "row-walk", "edge-equations"})
            QTest::newRow(method) << QString::fromLatin1(method);
    }
    void twoRedrawingsTogetherAreNamed()
    {
        QFETCH(QString, method);
        const std::vector<Scene> scenes = probeScenes(method.toLatin1().constData());
        const std::vector<Defect> all = redrawingsOf(scenes.front());
        DefectPictures pictures(scenes);
        const std::size_t stride = all.size() / 150 + 1; // ten to fifty pairs
        std::vector<std::array<Defect, 2>> pairs;
        for (std::size_t i = 0; 2 * i + 1 < all.size(); i += stride) {
            if (canBeTogether(all[i], all[2 * i + 1]))
                pairs.push_back({all[i], all[2 * i + 1]});
        }
        QVERIFY(pairs.size() >= 10);
        int wrong = 0;
        for (const auto &pair : casesToRun(pairs)) {
            std::vector<FoundPicture> found;
            for (const Scene &scene : scenes)
                found.push_back({found.size(), pictureWith(scene, pair)});
            const auto diagnosis = diagnose(pictures, found);
            if (diagnosis->verdict != DiagnosisVerdict::Wrong)
                continue;
            ++wrong;
            const QString both = pair[0].id + u" and "_s + pair[1].id;
            QVERIFY2(diagnosis->isExplained(), qPrintable(both));
            // If one of them alone, or another single one, draws the same, that is enough.
            const QStringList ids = idsOf(*diagnosis);
            const bool isNamed
                = ids.contains(both)
                || std::ranges::any_of(diagnosis->candidates, [](const auto &candidate) {
                       return candidate.defects.size() == 1 && candidate.distance == 0;
                   });
            QVERIFY2(isNamed, qPrintable(both + u": "_s + ids.join(u' ')));
        }
        QVERIFY(wrong > 0);
    }

    void aSecondDefectThatHardlyBringsItNearerIsNotNamed()
    {
        const Scene scene = probeScenes().front();
        const Defect first = defectNamed(scene, u"unsorted-colours"_s);
        const Picture alone = pictureWith(scene, std::span(&first, 1));
        Submission submission{scene, {}};
        const std::vector<Defect> all = defectsFor(scene);
        const auto hardlyChanges = [&](const Defect &second) {
            if (second.standsAlone || second.id == first.id || !canBeTogether(first, second))
                return false;
            submission.picture = pictureWith(scene, std::array{first, second});
            const std::int64_t changed = differingPixels(alone, submission.picture);
            return changed > 0 && changed < 4;
        };
        QVERIFY(std::ranges::any_of(all, hardlyChanges));
        for (std::size_t i = 0; i < 12; ++i) // colours that no program would write
            submission.picture.colours[i] = {{1, 2, 3}};

        const Diagnosis diagnosis = *diagnose(std::vector{submission});

        QVERIFY(!diagnosis.isExplained());
        const QStringList ids = idsOf(diagnosis);
        QVERIFY2(ids.contains(first.id), qPrintable(ids.join(u'\n')));
        for (const QString &each : ids)
            QVERIFY2(!each.contains(first.id + u" and "_s), qPrintable(each));
    }
};

PIXELPLUMB_TEST(TestDefectPairs)

} // namespace tst_defectpairs

#include "tst_defectpairs.moc"
