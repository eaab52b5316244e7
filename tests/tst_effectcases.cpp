// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "tests/support/caselist.h"

#include <QTest>

using namespace pixelplumb;

namespace {

constexpr ByteRounding nearest = ByteRounding::Nearest;

/// Those that draw effects, in exact arithmetic under the rules that they keep.
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
        remarks.append(verdict.contender.name() + QStringLiteral(": ")
                       + verdict.remarks.join(QStringLiteral("; ")));
    return remarks.join(u'\n');
}

} // namespace

/// The hard cases of effects, whose facts derive_effect_facts.py derives in fractions.
class TestEffectCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_cases = casesOf(QFINDTESTDATA("data/effect_cases.json")); }

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
        QCOMPARE(report.count(CaseOutcome::Passed), std::int64_t(12)); // four by three rules
    }

    void aFalseFactFallsShort()
    {
        HardCase hardCase = caseNamed(m_cases, QStringLiteral("effect_depth_last_bit"));
        hardCase.facts[FillRule::Closed].colourHash = "0123456789abcdef";

        const CaseReport report = checkCase(hardCase, exactContenders());

        QCOMPARE(report.count(CaseOutcome::FellShort), std::int64_t(4));
        QVERIFY(remarksOf(report).contains(u"colour hash"));
    }

    void methodsWithoutEffectsAreSkippedAndToldWhoHasThem()
    {
        const HardCase &hardCase = caseNamed(m_cases, QStringLiteral("effect_w_near_zero"));

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

QTEST_GUILESS_MAIN(TestEffectCases)
#include "tst_effectcases.moc"
