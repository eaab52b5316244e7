// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/mistakenprograms.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_edgetestdefects {

using namespace pixelplumb;

namespace {

QStringList methods() { return {u"edge-equations"_s, u"barycentric-rectangle"_s}; }

void addMethods()
{
    QTest::addColumn<QString>("method");
    for (const QString &method : methods())
        QTest::newRow(qPrintable(method)) << method;
}

/// The diagnosis of edgetests.py with these mistakes, from its pictures of the method's sheet.
Diagnosis diagnosed(const QString &method, const QStringList &mistakes, const char *box = "inward")
{
    const std::vector<Scene> scenes = probeSheet(method);
    const std::vector<Picture> pictures
        = drawnByStudent(u"edgetests"_s, {QString::fromLatin1(box)}, mistakes, scenes);
    std::vector<Submission> submissions;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        submissions.push_back({scenes[i], pictures[i]});
    return *diagnose(submissions);
}

} // namespace

/// The defects of edge tests match a program that was not written for them, in doubles.
class TestEdgeTestDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsNotCalledWrong_data() { addMethods(); }
    void aRightProgramIsNotCalledWrong()
    {
        QFETCH(QString, method);
        QVERIFY(diagnosed(method, {}).verdict != DiagnosisVerdict::Wrong);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        std::vector<std::pair<QString, QString>> all;
        for (const QString &method : methods()) {
            for (const ProgramMistake &mistake : mistakesOf(u"edgetests"_s)) {
                if (mistake.kind == u"test"_s)
                    all.emplace_back(method, mistake.ids.front());
            }
        }
        for (const auto &[method, id] : casesToRun(all, &std::pair<QString, QString>::first))
            QTest::addRow("%s of %s", qPrintable(id), qPrintable(method)) << method << id;
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);

        const Diagnosis diagnosis = diagnosed(method, {id});

        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().ids(), QStringList(id));
        QVERIFY(std::ranges::none_of(
            diagnosis.candidates.begin() + 1, diagnosis.candidates.end(),
            [](const DiagnosisCandidate &other) { return other.defects.size() == 1; }));
    }

    /// Some samples on an edge are drawn, because the third weight is rounded.
    void aStrictTestIsWrongThoughRoundingDecidesSomeSamples_data() { addMethods(); }
    void aStrictTestIsWrongThoughRoundingDecidesSomeSamples()
    {
        QFETCH(QString, method);

        const Diagnosis diagnosis = diagnosed(method, {u"strict-by-weights"_s});

        QCOMPARE(nameOf(diagnosis.verdict), u"wrong"_s);
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(named.ids(), QStringList(u"rule-open"_s));
        QVERIFY(named.undecidable > 0);
        QVERIFY(2 * named.undecidable < diagnosis.differing);
    }

    void anOutwardBoxWithAMistakeIsFoundButNotReported_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"edge-1-not-tested", "edge-1-tested-outside"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void anOutwardBoxWithAMistakeIsFoundButNotReported()
    {
        QFETCH(QString, id);

        const Diagnosis diagnosis = diagnosed(u"edge-equations"_s, {id}, "outward");

        QVERIFY(diagnosis.isExplained());
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(named.rightAlone(), QStringList(u"box-outward"_s));
        QStringList mistakes = named.ids();
        mistakes.removeAll(u"box-outward"_s);
        QCOMPARE(mistakes, QStringList(id));
        QCOMPARE(named.sentences(&Defect::forStudent).size(), 1);
    }

    /// Some programs keep the lowest eight bits of a level that fits no byte.
    void missingClampingIsReportedNextToTheMistake()
    {
        const std::vector<Scene> scenes = probeSheet(u"edge-equations"_s);
        std::vector<Defect> pair;
        for (const Defect &defect : defectsFor(scenes.front())) {
            if (defect.id == u"weights-doubled"_s || defect.id == u"levels-wrap"_s)
                pair.push_back(defect);
        }
        QCOMPARE(pair.size(), std::size_t(2));
        std::vector<Submission> submissions;
        for (const Scene &scene : scenes)
            submissions.push_back({scene, pictureWith(scene, pair)});

        const Diagnosis diagnosis = *diagnose(submissions);

        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().rightAlone(), QStringList(u"levels-wrap"_s));
        QCOMPARE(diagnosis.candidates.front().defects.size(), std::size_t(2));
    }
};

PIXELPLUMB_TEST(TestEdgeTestDefects)

} // namespace tst_edgetestdefects

#include "tst_edgetestdefects.moc"
