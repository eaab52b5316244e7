// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "tests/support/caselist.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <map>

namespace tst_shapecases {

using namespace pixelplumb;

namespace {

constexpr ByteRounding nearest = ByteRounding::Nearest;

std::vector<Contender> stableContenders()
{
    std::vector<Contender> contenders;
    for (const Method &method : methods()) {
        for (const Arithmetic arithmetic : method.stableArithmetics) {
            for (const FillRule rule : method.fillRules)
                contenders.push_back({&method, {arithmetic, rule, nearest}});
        }
    }
    return contenders;
}

bool isOutline(const HardCase &hardCase)
{
    return hardCase.kind == HardCaseKind::Circle
        && hardCase.shapes.front().fill == ShapeFill::Outline;
}

bool isOnWholePixels(const Shape &shape)
{
    return std::ranges::all_of(shape.vertices, [](const Vertex &vertex) {
        return vertex.position.x % unitsPerPixel == 0 && vertex.position.y % unitsPerPixel == 0;
    });
}

QString remarksOf(const CaseReport &report)
{
    QStringList remarks = report.remarks;
    for (const ContenderVerdict &verdict : report.verdicts)
        remarks.append(verdict.contender.name() + u": "_s + verdict.remarks.join(u"; "_s));
    return remarks.join(u'\n');
}

/// Falsifies a fact.
using Fault = void (*)(HardCase &hardCase);

ExpectedFacts &factsOf(HardCase &hardCase) { return hardCase.facts.begin()->second; }

} // namespace

/// The hard cases other than triangles near the origin: lines, circles, polygons, far meshes,
/// moving slivers, interpolation.
class TestShapeCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_cases = casesOf(testData("shape_cases.json")); }

    void holdsEveryKind()
    {
        std::map<HardCaseKind, int> counts;
        for (const HardCase &hardCase : m_cases) {
            ++counts[hardCase.kind];
            QVERIFY2(hardCase.displacements.isEmpty(), qPrintable(hardCase.id));
            QVERIFY2(!hardCase.facts.empty(), qPrintable(hardCase.id));
        }
        QCOMPARE(counts[HardCaseKind::Line], 17);
        QCOMPARE(counts[HardCaseKind::Circle], 12);
        QCOMPARE(counts[HardCaseKind::Polygon], 18);
        QCOMPARE(counts[HardCaseKind::Mesh], 6);
        QCOMPARE(counts[HardCaseKind::Sequence], 4);
        QCOMPARE(counts[HardCaseKind::Attributes], 5);
    }

    void everyStableMethodIsRight_data() { addRows(m_cases); }
    void everyStableMethodIsRight()
    {
        QFETCH(const HardCase *, hardCase);

        const CaseReport report = checkCase(*hardCase, stableContenders());

        QVERIFY2(report.count(CaseOutcome::FellShort) == 0, qPrintable(remarksOf(report)));
        // No method claims to draw every outlined circle correctly.
        QCOMPARE(report.count(CaseOutcome::Passed) > 0, !isOutline(*hardCase));
        if (hardCase->kind == HardCaseKind::Line)
            QCOMPARE(report.count(CaseOutcome::Passed), std::int64_t(2));
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

    void midpointIsRightOnCirclesOnWholePixels()
    {
        const Contender midpoint
            = {methodNamed(u"circle-midpoint"), {Arithmetic::Exact, FillRule::Closed, nearest}};
        QStringList right;
        QStringList expected;
        for (const HardCase &hardCase : m_cases) {
            if (!isOutline(hardCase))
                continue;
            if (checkCase(hardCase, {midpoint}).summary() == CaseOutcome::Passed)
                right.append(hardCase.id);
            if (isOnWholePixels(hardCase.shapes.front()))
                expected.append(hardCase.id);
        }
        QCOMPARE(right, expected);
        QCOMPARE(expected.size(), qsizetype(4));
    }

    // Every kind of fact is checked: methods that were right miss a falsified one.
    void aFalseFactFallsShort_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Fault>("fault");
        QTest::addColumn<QString>("remark");
        const auto add = [](const char *row, const char *id, const char *remark, Fault fault) {
            QTest::newRow(row) << QString::fromLatin1(id) << fault << QString::fromUtf8(remark);
        };
        const Fault count = [](HardCase &hardCase) { ++*factsOf(hardCase).pixelCount; };
        const Fault pixelHash
            = [](HardCase &hardCase) { factsOf(hardCase).pixelHash = "0123456789abcdef"; };
        const Fault histogram = [](HardCase &hardCase) { ++factsOf(hardCase).histogram[2]; };
        add("line, count", "shape_line_ties_steep", "pixel count 53 instead of 54", count);
        add("line, pixels", "shape_line_off_pixel_ties", "pixel hash", pixelHash);
        add("circle, count", "shape_circle_filled_far", "pixel count 806 instead of 807", count);
        add("circle, pixels", "shape_circle_filled_fractional", "pixel hash", pixelHash);
        add("circle, colour", "shape_circle_filled_fractional", "channel sums",
            [](HardCase &hardCase) { ++factsOf(hardCase).channelSums->back(); });
        add("polygon, spans", "shape_polygon_pentagram_non_zero", "span hash",
            [](HardCase &hardCase) { factsOf(hardCase).spanHash = "0123456789abcdef"; });
        add("polygon, pixels", "shape_polygon_hole_other_turn", "pixel hash", pixelHash);
        add("polygons, overlap", "shape_polygon_tiling",
            "coverage (times×pixels) 1×400 instead of 1×400 2×1", histogram);
        add("mesh", "shape_mesh_grid_2_20", "coverage (times×pixels)", histogram);
        add("sequence, frames", "shape_sequence_turning_sliver", "pixel counts",
            [](HardCase &hardCase) { ++factsOf(hardCase).frameCounts[3]; });
        add("sequence, flicker", "shape_sequence_far_sliver", "toggles",
            [](HardCase &hardCase) { ++*factsOf(hardCase).toggles; });
        add("attributes, count", "shape_attributes_depth_range", "pixel count", count);
        add("attributes, z", "shape_attributes_samples_on_edges",
            "pixel (3, 1): z is 3/10 instead of 1/3", [](HardCase &hardCase) {
                hardCase.points.front().values[u"z"_s] = Quantity::rational(1, 3);
            });
        add("attributes, v", "shape_attributes_far_sliver", ": v is ", [](HardCase &hardCase) {
            hardCase.points.back().values[u"v"_s] = Quantity::integer(7);
        });
    }
    void aFalseFactFallsShort()
    {
        QFETCH(QString, id);
        QFETCH(Fault, fault);
        QFETCH(QString, remark);
        HardCase hardCase = caseNamed(m_cases, id);
        fault(hardCase);

        const CaseReport report = checkCase(hardCase, stableContenders());

        QCOMPARE(report.summary(), CaseOutcome::FellShort);
        QVERIFY2(remarksOf(report).contains(remark), qPrintable(remarksOf(report)));
    }

    void onlyInterpolationAnswersForValues()
    {
        HardCase hardCase = caseNamed(m_cases, u"shape_attributes_level_sliver"_s);
        hardCase.points.front().values[u"z"_s] = Quantity::integer(0);

        const CaseReport report = checkCase(hardCase, stableContenders());

        for (const ContenderVerdict &verdict : report.verdicts) {
            if (!hardCase.facts.contains(verdict.contender.settings.fillRule))
                continue;
            // Under top-left y points down, so the points' values are those of the opposite
            // direction.
            const bool answers = verdict.contender.method->family == MethodFamily::Interpolation
                && verdict.contender.settings.fillRule != FillRule::TopLeft;
            QCOMPARE(verdict.outcome == CaseOutcome::FellShort, answers);
        }
        // Three forms under two rules, and the row form under one.
        QCOMPARE(report.count(CaseOutcome::FellShort), std::int64_t(7));
    }

    // Rounding forms fall short on exactly these cases.
    void roundingFormsFallShortWhereRecorded_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QStringList>("ids");
        QTest::newRow("line-dda") << u"line-dda"_s
                                  << QStringList{u"shape_line_far_2_20"_s,
                                                 u"shape_line_far_minus_16384"_s,
                                                 u"shape_line_far_2_30"_s,
                                                 u"shape_line_off_pixel_ties"_s,
                                                 u"shape_line_off_pixel_steep_far"_s,
                                                 u"shape_line_long_primes"_s,
                                                 u"shape_line_drift_at_16000"_s};
        QTest::newRow("polygon-parity")
            << u"polygon-parity"_s
            << QStringList{
                   u"shape_polygon_touching_itself"_s,    u"shape_polygon_pentagram_even_odd"_s,
                   u"shape_polygon_pentagram_non_zero"_s, u"shape_polygon_far_sliver"_s,
                   u"shape_polygon_far_crossing"_s,       u"shape_polygon_far_tiling"_s,
                   u"shape_polygon_steep_drift"_s};
    }
    void roundingFormsFallShortWhereRecorded()
    {
        QFETCH(QString, method);
        QFETCH(QStringList, ids);
        const Method *drawnBy = methodNamed(method);

        QStringList fallenShort;
        for (const HardCase &hardCase : m_cases) {
            if (hardCase.shapes.empty())
                continue;
            const CaseReport report = checkCase(
                hardCase, {{drawnBy, {Arithmetic::Float32, drawnBy->fillRules.front(), nearest}}});
            if (report.summary() == CaseOutcome::FellShort)
                fallenShort.append(hardCase.id);
        }

        QCOMPARE(fallenShort, ids);
    }

    void skipsAPolygonThatAMethodRefuses()
    {
        const CaseReport report = checkCase(
            caseNamed(m_cases, u"shape_polygon_pentagram_non_zero"_s),
            {{methodNamed(u"polygon-fan"), {Arithmetic::Exact, FillRule::TopLeft, nearest}},
             {methodNamed(u"polygon-delaunay"), {Arithmetic::Exact, FillRule::TopLeft, nearest}}});

        QCOMPARE(report.summary(), CaseOutcome::Skipped);
        QVERIFY(report.verdicts[0].remarks.value(0).startsWith(u"It is not convex"));
        QVERIFY(report.verdicts[1].remarks.value(0).startsWith(u"Its edges "));
    }

    void saysWhatNoMethodDraws()
    {
        const CaseReport report
            = checkCase(caseNamed(m_cases, u"shape_circle_ties"_s), stableContenders());

        QCOMPARE(
            report.remarks,
            QStringList{u"none of the methods checked draws an outlined circle; by name can be "
                        "checked: circle-midpoint, circle-explicit, circle-parametric, "
                        "stroke-coverage"_s});
    }

private:
    std::vector<HardCase> m_cases;
};

PIXELPLUMB_TEST(TestShapeCases)

} // namespace tst_shapecases

#include "tst_shapecases.moc"
