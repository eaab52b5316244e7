// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "tests/support/caselist.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_effectcases {

using namespace pixelplumb;

namespace {

constexpr ByteRounding nearest = ByteRounding::Nearest;

/// The methods that draw effects, in exact arithmetic under the rules that they support.
std::vector<Contender> exactContenders()
{
    std::vector<Contender> contenders;
    for (const QStringView id : {u"column-scan", u"interpolate-bilinear", u"interpolate-plane",
                                 u"interpolate-barycentric"}) {
        const Method *method = methodNamed(id);
        for (const FillRule rule : method->fillRules)
            contenders.push_back({method, {Arithmetic::Exact, rule, nearest}});
    }
    return contenders;
}

QString remarksOf(const CaseReport &report)
{
    QStringList remarks;
    for (const ContenderVerdict &verdict : report.verdicts)
        remarks.append(verdict.contender.name() + u": "_s + verdict.remarks.join(u"; "_s));
    return remarks.join(u'\n');
}

} // namespace

/// The hard cases of effects; derive_effect_facts.py derives their facts in fractions.
class TestEffectCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_cases = casesOf(testData("effect_cases.json")); }

    void everyCaseHasFactsUnderFourRulesOnTheLattice()
    {
        QCOMPARE(m_cases.size(), std::size_t(26));
        for (const HardCase &hardCase : m_cases) {
            QCOMPARE(hardCase.kind, HardCaseKind::Effects);
            QCOMPARE(hardCase.facts.size(), std::size_t(4));
            QVERIFY2(hardCase.displacements.isEmpty(), qPrintable(hardCase.id));
        }
    }

    void theOracleIsRight_data() { addRows(m_cases); }
    void theOracleIsRight()
    {
        QFETCH(const HardCase *, hardCase);
        for (const auto &[rule, facts] : hardCase->facts) {
            const QStringList shortfalls
                = shortfallsOf(*hardCase, {Arithmetic::Exact, rule, nearest}, drawTruly);
            QVERIFY2(shortfalls.isEmpty(), qPrintable(shortfalls.join(u'\n')));
        }
    }

    void everyMethodThatDrawsEffectsIsRightInExactArithmetic_data() { addRows(m_cases); }
    void everyMethodThatDrawsEffectsIsRightInExactArithmetic()
    {
        QFETCH(const HardCase *, hardCase);

        const CaseReport report = checkCase(*hardCase, exactContenders());

        QVERIFY2(report.count(CaseOutcome::FellShort) == 0, qPrintable(remarksOf(report)));
        QCOMPARE(report.count(CaseOutcome::Passed),
                 std::int64_t(15)); // three methods by four rules, one by three
    }

    void inFloat32MethodsFallShortWhereRecorded_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QStringList>("ids");
        QTest::newRow("column-scan")
            << u"column-scan"_s
            << QStringList{
                   u"effect_board_in_perspective"_s,         u"effect_far_away"_s,
                   u"effect_uv_on_borders_in_perspective"_s, u"effect_depth_last_bit"_s,
                   u"effect_depth_crossing_on_samples"_s,    u"effect_depth_fighting_16_bits"_s,
                   u"effect_t_junction_in_perspective"_s,    u"effect_alphas_of_0_and_254"_s,
                   u"effect_slivers_by_16_samples"_s,        u"effect_samples_and_depth"_s};
        QTest::newRow("interpolate-bilinear")
            << u"interpolate-bilinear"_s
            << QStringList{u"effect_board_in_perspective"_s,
                           u"effect_far_away"_s,
                           u"effect_uv_on_borders_in_perspective"_s,
                           u"effect_depth_last_bit"_s,
                           u"effect_depth_crossing_on_samples"_s,
                           u"effect_depth_fighting_exact"_s,
                           u"effect_depth_fighting_16_bits"_s,
                           u"effect_depth_24_bits_ties"_s,
                           u"effect_t_junction_in_perspective"_s,
                           u"effect_alphas_of_0_and_254"_s,
                           u"effect_samples_and_depth"_s};
        QTest::newRow("interpolate-plane")
            << u"interpolate-plane"_s
            << QStringList{u"effect_far_away"_s, u"effect_uv_on_borders_in_perspective"_s,
                           u"effect_depth_last_bit"_s, u"effect_t_junction_in_perspective"_s,
                           u"effect_samples_and_depth"_s};
        QTest::newRow("interpolate-barycentric")
            << u"interpolate-barycentric"_s
            << QStringList{u"effect_far_away"_s,           u"effect_uv_on_borders_in_perspective"_s,
                           u"effect_depth_last_bit"_s,     u"effect_depth_crossing_on_samples"_s,
                           u"effect_depth_24_bits_ties"_s, u"effect_alphas_of_0_and_254"_s,
                           u"effect_without_area"_s,       u"effect_samples_and_depth"_s};
    }
    void inFloat32MethodsFallShortWhereRecorded()
    {
        QFETCH(QString, method);
        QFETCH(QStringList, ids);
        const Method *drawnBy = methodNamed(method);
        std::vector<Contender> contenders;
        for (const FillRule rule : drawnBy->fillRules)
            contenders.push_back({drawnBy, {Arithmetic::Float32, rule, nearest}});

        QStringList fallenShort;
        for (const HardCase &hardCase : m_cases) {
            if (checkCase(hardCase, contenders).summary() == CaseOutcome::FellShort)
                fallenShort.append(hardCase.id);
        }

        QCOMPARE(fallenShort, ids);
    }

    void aFalseFactFallsShort()
    {
        HardCase hardCase = caseNamed(m_cases, u"effect_depth_last_bit"_s);
        hardCase.facts[FillRule::Closed].colourHash = "0123456789abcdef";

        const CaseReport report = checkCase(hardCase, exactContenders());

        QCOMPARE(report.count(CaseOutcome::FellShort), std::int64_t(4));
        QVERIFY(remarksOf(report).contains(u"colour hash"));
    }

    void methodsWithoutEffectsAreSkippedAndNameThoseWithThem()
    {
        const HardCase &hardCase = caseNamed(m_cases, u"effect_w_near_zero"_s);

        const CaseReport report = checkCase(
            hardCase,
            {{methodNamed(u"edge-equations"), {Arithmetic::Exact, FillRule::Closed, nearest}},
             {methodNamed(u"column-scan"), {Arithmetic::Fixed16, FillRule::Closed, nearest}}});

        QCOMPARE(report.summary(), CaseOutcome::Skipped);
        QVERIFY(report.verdicts[0].remarks.value(0).contains(u"interpolate-plane"));
        QVERIFY(report.verdicts[1].remarks.value(0).contains(u"float32"));
    }

private:
    std::vector<HardCase> m_cases;
};

PIXELPLUMB_TEST(TestEffectCases)

} // namespace tst_effectcases

#include "tst_effectcases.moc"
