// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "tests/support/listings/listingscenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_walklistings {

using namespace pixelplumb;

namespace {

constexpr unsigned seed = 13;

/// A is the only number that a listing does not compute.
ListingRun listingOf(const TracedScene &traced, const Pseudocode &code)
{
    ListingNames names = vertexNames(traced.scene.triangles.front(), traced.scene.frame);
    const ListingNames setUp = setUpNames(traced);
    if (const auto area = setUp.find(u"A"_s); area != setUp.end())
        names.insert(*area);
    return ListingRun(code, names, frameBox(traced.scene.frame));
}

/// The listing of a triangle from its vertices on, as a student would write it.
ListingRun listingOf(const TracedScene &traced)
{
    return listingOf(traced, pseudocodeOf(traced, 0));
}

/// Where the lines that a listing ran for a pixel are not those that are marked at the pixel's
/// step.
QString wrongMark(const ListingRun &run, const TracedScene &traced)
{
    const Pseudocode code = pseudocodeOf(traced, 0);
    const ScanTrace &trace = *traced.trace;
    for (std::size_t index = 0; index < trace.stepCount(); ++index) {
        const TraceStep step = trace.stepAt(index);
        if (step.kind != StepKind::Sample)
            continue;
        const PixelChange &change = trace.changes()[step.sample];
        const std::vector<std::size_t> &ran = run.linesOfPixels().at({change.x, change.y});
        for (std::size_t line = 0; line < code.size(); ++line) {
            const bool isMarked = std::ranges::count(code[line].moments, momentOf(trace, index)) > 0
                && !code[line].text.startsWith(u"for each "_s);
            const bool isCondition = code[line].text.startsWith(u"if "_s); // that need not hold
            if (isMarked != (std::ranges::count(ran, line) > 0) && !(isMarked && isCondition))
                return u"(%1, %2): %3"_s.arg(change.x).arg(change.y).arg(code[line].text);
        }
    }
    return {};
}

/// The set-up ends with "done" where only the closed rule would draw a triangle without area, and
/// where all vertices lie beyond one side of the frame, which matters where variants leave the
/// triangle.
bool isDoneInSetUp(const TracedScene &traced)
{
    const SetUpRecord setUp = traced.trace->setUp(0);
    const ScanSettings &settings = traced.scene.settings;
    return setUp.rejection
        && (!settings.variants.isEmpty()
            || (setUp.zeroArea && settings.fillRule != FillRule::Closed));
}

} // namespace

/// The printed pseudocode of the walks between two edges is executed, its set-up included, and
/// compared with their kernels.
class TestWalkListings : public QObject {
    Q_OBJECT

private slots:
    void listingsOfWalksDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<VariantSet>("variants");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *id :
             {"column-scan", "row-walk", "column-scan-constant-rate", "row-walk-constant-rate",
              "column-scan-bias", "interpolate-bilinear", "interpolate-bilinear-rows",
              "interpolate-plane", "interpolate-barycentric", "midpoint-outline-fill"}) {
            const Method &method = *methodNamed(QString::fromLatin1(id));
            for (const Arithmetic arithmetic : listedArithmetics(method)) {
                const std::string numbers(nameOf(arithmetic));
                for (const FillRule rule : method.fillRules) {
                    const std::string edges(nameOf(rule));
                    QTest::addRow("%s, %s, %s", id, numbers.c_str(), edges.c_str())
                        << method.id << rule << VariantSet() << arithmetic;
                    for (const Variant variant : method.variants)
                        QTest::addRow("%s, %s, %s, %s", id, numbers.c_str(), edges.c_str(),
                                      std::string(nameOf(variant)).c_str())
                            << method.id << rule << VariantSet().with(variant) << arithmetic;
                }
            }
        }
    }
    /// Of each pixel the lines that computed it are marked, and no others.
    void listingsOfWalksDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(FillRule, rule);
        QFETCH(VariantSet, variants);
        QFETCH(Arithmetic, arithmetic);
        const int count = arithmetic == Arithmetic::Exact ? 200 : 60;
        std::mt19937 random(seed);
        std::size_t drawn = 0;
        for (int i = 0; i < count; ++i) {
            Scene scene = oddTriangleScene(i, random);
            scene.method = id.toStdString();
            scene.settings.fillRule = rule;
            scene.settings.variants = variants;
            scene.settings.arithmetic = arithmetic;
            const auto traced = traceScene(scene);
            if (isDoneInSetUp(*traced))
                continue;
            ListingRun run = listingOf(*traced);
            const QString departure = departureOf(run, *traced);
            QVERIFY2(departure.isEmpty(),
                     qPrintable(u"seed %1, triangle %2: %3"_s.arg(seed).arg(i).arg(departure)));
            const QString mark = wrongMark(run, *traced);
            QVERIFY2(mark.isEmpty(), qPrintable(mark));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > std::size_t(7 * count));
    }

    /// The fault of a student who takes a column's bound for its first sample.
    void aListingWithoutItsPreStepIsFound()
    {
        Scene scene;
        scene.triangles = {Triangle{{{{latticePixel(1, 1), {{255, 0, 0}}},
                                      {latticePixel(11, 3), {{0, 255, 0}}},
                                      {latticePixel(4, 10), {{0, 0, 255}}}}}}};
        scene.method = "column-scan";
        const auto traced = traceScene(scene);
        Pseudocode code = pseudocodeOf(*traced, 0);
        for (PseudocodeLine &line : code)
            line.text.remove(u" + (y − y_B)·ΔR"_s);
        ListingRun run = listingOf(*traced, code);
        QVERIFY(departureOf(run, *traced).contains(u"listing (4, 2) "_s));
    }
};

PIXELPLUMB_TEST(TestWalkListings)

} // namespace tst_walklistings

#include "tst_walklistings.moc"
