// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "tests/support/framespec.h"
#include "tests/support/listings/listingscenes.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <memory>
#include <set>

namespace tst_listings {

using namespace pixelplumb;

namespace {

constexpr unsigned edgeTestSeed = 7, lineSeed = 11;

/// The coordinates and levels of a line's ends in the order given: x₀, y₀, R₀ …
ListingNames endNames(const Shape &line)
{
    ListingNames names;
    for (std::size_t end = 0; end < 2; ++end) {
        const QChar digit = end == 0 ? u'₀' : u'₁';
        const Vertex &vertex = line.vertices[end];
        names[QString(u'x') + digit] = inPixels(vertex.position.x);
        names[QString(u'y') + digit] = inPixels(vertex.position.y);
        for (std::size_t channel = 0; channel < 3; ++channel)
            names[QString(channelLetters[channel]) + digit] = vertex.colour.channels[channel];
    }
    return names;
}

/// The numbers of a triangle by the letters of the method's slides, and the off-screen point.
ListingNames triangleNames(const TracedScene &traced)
{
    ListingNames names = vertexNames(traced.scene.triangles.front(), traced.scene.frame);
    const bool isCramer = traced.method->id == u"barycentric-cramer"_s;
    for (const auto &[name, value] : ListingNames(names)) {
        const int vertex = name.back().unicode() - u'₀';
        names[name.chopped(1) + u'_' + QChar((isCramer ? u'A' : u'a') + vertex)] = value;
    }
    const ListingNames setUp = setUpNames(traced);
    for (const QString &name : {u"x_r"_s, u"y_r"_s}) {
        if (const auto given = setUp.find(name); given != setUp.end())
            names.insert(*given);
    }
    return names;
}

Scene oddLineScene(const QString &id, int number, std::mt19937 &random)
{
    const Lattice step = number % 3 == 0 ? 37 : number % 3 == 1 ? unitsPerPixel / 2 : unitsPerPixel;
    std::uniform_int_distribution<Lattice> place(0, 12 * unitsPerPixel / step);
    std::uniform_int_distribution<int> level(0, 255);
    Shape line = lineAtUnits({place(random) * step, place(random) * step},
                             {place(random) * step, place(random) * step});
    for (Vertex &end : line.vertices)
        for (auto &channel : end.colour.channels)
            channel = std::uint8_t(level(random));
    return sceneOf(line, qPrintable(id), number % 4 == 3 ? frameOf(9, 7, 2, 1) : frameOf(14, 13));
}

ListingRun runOf(const TracedScene &traced, const Pseudocode &code)
{
    const ListingNames names = traced.scene.shapes.empty() ? triangleNames(traced)
                                                           : endNames(traced.scene.shapes.front());
    return ListingRun(code, names, frameBox(traced.scene.frame));
}

/// A misreading of a line: the first of these texts in it becomes the other one.
using Misreading = std::pair<QString, QString>;
const std::vector<Misreading> misreadings = {
    {u" − "_s, u" + "_s},   {u" + "_s, u" − "_s},   {u" < "_s, u" > "_s},   {u" > "_s, u" < "_s},
    {u" ≥ "_s, u" < "_s},   {u" ≤ "_s, u" > "_s},   {u" = "_s, u" ≠ "_s},   {u" ≠ "_s, u" = "_s},
    {u"/"_s, u"·"_s},       {u"min("_s, u"max("_s}, {u"max("_s, u"min("_s}, {u"x₀"_s, u"x₁"_s},
    {u"x_b"_s, u"x_c"_s},   {u"x_B"_s, u"x_C"_s},   {u"y₁"_s, u"y₀"_s},     {u"y_b"_s, u"y_c"_s},
    {u"y_B"_s, u"y_C"_s},   {u"s₀·"_s, QString()},  {u"D·"_s, QString()},   {u"−D"_s, u"D"_s},
    {u"f_a·"_s, QString()}, {u"by x"_s, u"by y"_s}, {u" ½"_s, u" 1"_s},     {u"·R_a"_s, u"·R_b"_s}};

} // namespace

/// The printed pseudocode of edge tests and lines is executed and compared with their kernels.
class TestListings : public QObject {
    Q_OBJECT

    std::set<QString> m_misread; ///< the lines that rows have misread, after their method's id

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
            if (setUp.rejection && setUp.zeroArea)
                continue; // no rule but the closed one draws it
            ListingRun run = runOf(*traced, pseudocodeOf(*traced, 0));
            const QString departure = departureOf(run, *traced);
            QVERIFY2(
                departure.isEmpty(),
                qPrintable(u"seed %1, triangle %2: %3"_s.arg(edgeTestSeed).arg(i).arg(departure)));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > std::size_t(4 * count));
    }

    /// Lines in every octant, of no length, with ties and beyond the frame, with each variant and
    /// with all of them.
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
                VariantSet all;
                for (const Variant variant : method.variants) {
                    QTest::addRow("%s, %s, %s", qPrintable(method.id), numbers.c_str(),
                                  std::string(nameOf(variant)).c_str())
                        << method.id << VariantSet().with(variant) << arithmetic;
                    all = all.with(variant);
                }
                if (method.variants.size() > 1)
                    QTest::addRow("%s, %s, all variants", qPrintable(method.id), numbers.c_str())
                        << method.id << all << arithmetic;
            }
        }
    }
    void listingsOfLinesDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(VariantSet, variants);
        QFETCH(Arithmetic, arithmetic);
        std::mt19937 random(lineSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < 200; ++i) {
            Scene scene = oddLineScene(id, i, random);
            scene.settings.variants = variants;
            scene.settings.arithmetic = arithmetic;
            const auto traced = traceScene(scene);
            ListingRun run = runOf(*traced, pseudocodeOf(*traced, 0));
            const QString departure = departureOf(run, *traced);
            QVERIFY2(departure.isEmpty(),
                     qPrintable(u"seed %1, %2: %3"_s.arg(lineSeed).arg(nameOf(scene.shapes.front()),
                                                                       departure)));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 100);
    }

    /// A set-up is run, not told: whatever of a line is misread, some primitive is drawn wrong.
    void aSetUpThatIsMisreadIsFound_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<VariantSet>("variants");
        for (const Method &method : methods()) {
            if (method.family != MethodFamily::Lines && !method.id.startsWith(u"edge-equations"_s)
                && !method.id.startsWith(u"barycentric-"_s))
                continue;
            for (const FillRule rule : method.fillRules)
                QTest::addRow("%s, %s", qPrintable(method.id), std::string(nameOf(rule)).c_str())
                    << method.id << rule << VariantSet();
            for (const Variant variant : method.variants)
                if (method.supports(FillRule::Closed)) // of which most is seen
                    QTest::addRow("%s, %s", qPrintable(method.id),
                                  std::string(nameOf(variant)).c_str())
                        << method.id << FillRule::Closed << VariantSet().with(variant);
        }
    }
    void aSetUpThatIsMisreadIsFound()
    {
        QFETCH(QString, id);
        QFETCH(FillRule, rule);
        QFETCH(VariantSet, variants);
        const bool isLine = methodNamed(id)->family == MethodFamily::Lines;
        std::mt19937 random(edgeTestSeed);
        std::vector<std::shared_ptr<const TracedScene>> scenes;
        for (int i = 0; i < 150; ++i) {
            Scene scene = isLine ? oddLineScene(id, i, random) : oddTriangleScene(i, random);
            if (!isLine) { // its ties are seen
                const FrameOrigin origin = scene.frame.origin;
                scene.frame = frameOf(18, 18, -4, -4);
                scene.frame.origin = origin;
            }
            scene.method = id.toStdString();
            scene.settings.fillRule = rule;
            scene.settings.variants = variants;
            auto traced = traceScene(scene);
            if (!traced->trace->setUp(0).rejection)
                scenes.push_back(std::move(traced));
        }
        const auto isFound = [&](const QString &line, const QString &misread) {
            return std::ranges::any_of(scenes, [&](const auto &traced) {
                Pseudocode code = pseudocodeOf(*traced, 0);
                const auto at = std::ranges::find(code, line, &PseudocodeLine::text);
                if (at == code.end())
                    return false;
                at->text = misread;
                ListingRun run = runOf(*traced, code);
                return !departureOf(run, *traced).isEmpty();
            });
        };
        std::set<QString> lines;
        for (const auto &traced : scenes) {
            for (const PseudocodeLine &line : pseudocodeOf(*traced, 0)) {
                if (line.moments == std::vector{Moment::SetUp})
                    lines.insert(line.text);
            }
        }
        if (!variants.isEmpty()) // else another test has run them
            QVERIFY(!isFound(*lines.begin(), *lines.begin()));
        QStringList survivors;
        for (const QString &line : lines) {
            if (!m_misread.insert(id + line).second)
                continue;
            for (const auto &[read, as] : misreadings) {
                const QString told = line.section(u" — "_s, 0, 0);
                const qsizetype place = told.indexOf(read);
                // Where nothing is rounded, an edge has the same values counted from either end.
                if (line.startsWith(u"E₀: u₀, v₀ ← "_s) && place > told.indexOf(u" if "_s))
                    continue;
                if (place >= 0 && !isFound(line, QString(told).replace(place, read.size(), as)))
                    survivors.append(line + u" with "_s + as + u" for "_s + read);
            }
        }
        QVERIFY2(survivors.isEmpty(), qPrintable(survivors.join(u'\n')));
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
            ListingRun run = runOf(*traced, code);
            for (const char16_t *walked : {u"E₀", u"E₁", u"E₂", u"α", u"β", u"γ", u"R", u"G", u"B"})
                run.state().set(QString::fromUtf16(walked), 0);
            run.run();
            QVERIFY(run.pixels() != pixelsOf(*traced));
        }
    }
};

PIXELPLUMB_TEST(TestListings)

} // namespace tst_listings

#include "tst_listings.moc"
