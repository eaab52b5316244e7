// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "tests/support/framespec.h"
#include "tests/support/listings/listingscenes.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_listings {

using namespace pixelplumb;

namespace {

constexpr unsigned edgeTestSeed = 7, lineSeed = 11;

/// The pixel's place along a coordinate.
Lattice rounded(Lattice coordinate)
{
    return (coordinate + unitsPerPixel / 2) & ~(unitsPerPixel - 1);
}

/// Whether a method that leads by decisions exchanges x and y of these ends.
bool isSteep(const LatticePoint &a, const LatticePoint &b)
{
    return std::abs(b.y - a.y) >= std::abs(b.x - a.x);
}

/// Adds the levels of the ends, unless the set-up has them as numbers. The end with the smaller x
/// comes first; of a steep line that with the smaller y.
void addColours(ListingNames &names, const LatticePoint &a, const LatticePoint &b,
                const Shape &line)
{
    const bool isInOrder = isSteep(a, b) ? a.y <= b.y : a.x <= b.x;
    const Vertex &first = isInOrder ? line.vertices.front() : line.vertices.back();
    const Vertex &second = isInOrder ? line.vertices.back() : line.vertices.front();
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = channelLetters[i];
        names.try_emplace(letter + u'₀', first.colour.channels[i]);
        names.try_emplace(letter + u'₁', second.colour.channels[i]);
    }
}

/// The samples that the kernel visits.
SampleBox boxOf(const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    const SpanRecord first = trace.span(0);
    const SpanRecord last = trace.span(trace.spanCount() - 1);
    const std::int64_t end = last.place.coordinate + 1;
    return first.place.axis == SpanAxis::Row
        ? SampleBox{first.firstDrawn, first.endDrawn, first.place.coordinate, end}
        : SampleBox{first.place.coordinate, end, first.firstDrawn, first.endDrawn};
}

} // namespace

/// The printed pseudocode of edge tests and lines is executed and compared with their kernels.
class TestListings : public QObject {
    Q_OBJECT

private slots:
    /// The listing is run as printed, line by line: under every rule, with ties.
    void listingsOfEdgeTestsDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *id :
             {"edge-equations", "edge-equations-incremental", "edge-equations-solved",
              "edge-equations-canonical", "barycentric-all", "barycentric-rectangle",
              "barycentric-incremental", "barycentric-cramer", "barycentric-off-screen",
              "barycentric-relative"}) {
            const Method &method = *methodNamed(QString::fromLatin1(id));
            for (const Arithmetic arithmetic : listedArithmetics(method))
                for (const FillRule rule : method.fillRules)
                    QTest::addRow("%s, %s, %s", id, std::string(nameOf(arithmetic)).c_str(),
                                  std::string(nameOf(rule)).c_str())
                        << method.id << rule << arithmetic;
        }
    }
    void listingsOfEdgeTestsDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(FillRule, rule);
        QFETCH(Arithmetic, arithmetic);
        const int count = arithmetic == Arithmetic::Exact ? 200 : 48;
        std::mt19937 random(edgeTestSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < count; ++i) {
            Scene scene = oddTriangleScene(i, random);
            scene.method = id.toStdString();
            scene.settings.fillRule = rule;
            scene.settings.arithmetic = arithmetic;
            const auto traced = traceScene(scene);
            const SetUpRecord setUp = traced->trace->setUp(0);
            if (setUp.rejection)
                continue;
            ListingNames names = setUpNames(*traced);
            if (setUp.zeroArea)
                names.merge(vertexNames(scene.triangles.front(), scene.frame));
            ListingRun run(pseudocodeOf(*traced, 0), names, boxOf(*traced));
            const QString departure = departureOf(run, *traced);
            QVERIFY2(
                departure.isEmpty(),
                qPrintable(u"seed %1, triangle %2: %3"_s.arg(edgeTestSeed).arg(i).arg(departure)));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > std::size_t(4 * count));
    }

    /// Lines in every octant, with ties and beyond the frame, and with the variants that the
    /// listing knows.
    void listingsOfLinesDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<VariantSet>("variants");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const Method &method : methods()) {
            if (method.family != MethodFamily::Lines)
                continue;
            for (const Arithmetic arithmetic : listedArithmetics(method)) {
                const std::string numbers(nameOf(arithmetic));
                QTest::addRow("%s, %s", qPrintable(method.id), numbers.c_str())
                    << method.id << VariantSet() << arithmetic;
                for (const Variant variant : method.variants) {
                    QTest::addRow("%s, %s, %s", qPrintable(method.id), numbers.c_str(),
                                  std::string(nameOf(variant)).c_str())
                        << method.id << VariantSet().with(variant) << arithmetic;
                }
            }
        }
    }
    void listingsOfLinesDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(VariantSet, variants);
        QFETCH(Arithmetic, arithmetic);
        std::mt19937 random(lineSeed);
        std::uniform_int_distribution<int> level(0, 255);
        std::size_t drawn = 0;
        for (int i = 0; i < 200; ++i) {
            const Lattice step = i % 3 == 0 ? 37 : i % 3 == 1 ? unitsPerPixel / 2 : unitsPerPixel;
            std::uniform_int_distribution<Lattice> place(0, 12 * unitsPerPixel / step);
            Shape line = lineAtUnits({place(random) * step, place(random) * step},
                                     {place(random) * step, place(random) * step});
            for (Vertex &end : line.vertices)
                for (auto &channel : end.colour.channels)
                    channel = std::uint8_t(level(random));
            Scene scene
                = sceneOf(line, qPrintable(id), i % 4 == 3 ? frameOf(9, 7, 2, 1) : frameOf(14, 13));
            scene.settings.variants = variants;
            scene.settings.arithmetic = arithmetic;
            const auto traced = traceScene(scene);
            const SetUpRecord setUp = traced->trace->setUp(0);
            if (setUp.rejection)
                continue;
            ListingNames names = setUpNames(*traced);
            LatticePoint a = line.vertices[0].position, b = line.vertices[1].position;
            if (methodNamed(id)->roundsPoints) {
                a = {rounded(a.x), rounded(a.y)};
                b = {rounded(b.x), rounded(b.y)};
            }
            addColours(names, a, b, line);
            const bool isExchanged
                = id != u"line-slope-intercept"_s && id != u"line-parametric"_s && isSteep(a, b);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(scene.frame),
                           ListingRun::SetUp::Given,
                           isExchanged ? ListingRun::Exchange::Axes : ListingRun::Exchange::None);
            const QString departure = departureOf(run, *traced);
            QVERIFY2(departure.isEmpty(),
                     qPrintable(u"seed %1, %2: %3"_s.arg(lineSeed).arg(nameOf(line), departure)));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 300);
    }

    /// The reviewers saw this printed: if the start of the line is not kept, nonsense is drawn.
    void aListingThatDoesNotGoBackToTheLinesStartIsFound()
    {
        for (const char *id : {"edge-equations-incremental", "barycentric-incremental"}) {
            Scene scene;
            scene.frame = frameOf(14, 13);
            scene.triangles = {Triangle{{{{latticePixel(1, 1), {{255, 0, 0}}},
                                          {latticePixel(11, 3), {{0, 255, 0}}},
                                          {latticePixel(4, 10), {{0, 0, 255}}}}}}};
            scene.method = id;
            const auto traced = traceScene(scene);
            Pseudocode code = pseudocodeOf(*traced, 0);
            const auto erased = std::erase_if(code, [](const PseudocodeLine &line) {
                return line.text.contains(u"back at the"_s);
            });
            QCOMPARE(erased, std::size_t(1));
            auto names = setUpNames(*traced);
            for (const char16_t *walked : {u"E₀", u"E₁", u"E₂", u"α", u"β", u"γ", u"R", u"G", u"B"})
                names.emplace(QString::fromUtf16(walked), 0);
            ListingRun run(code, names, boxOf(*traced));
            run.run();
            QVERIFY(run.pixels() != pixelsOf(*traced));
        }
    }
};

PIXELPLUMB_TEST(TestListings)

} // namespace tst_listings

#include "tst_listings.moc"
