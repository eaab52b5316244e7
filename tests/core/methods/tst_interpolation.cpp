// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

namespace tst_interpolation {

using namespace pixelplumb;

namespace {

constexpr std::array forms
    = {"interpolate-bilinear", "interpolate-plane", "interpolate-barycentric"};
constexpr std::array rules = {FillRule::Closed, FillRule::HalfOpenColumn};

VertexAttributes anyAttributes(SeededRandom &dice, Attribute largest)
{
    const auto any = [&] { return dice.between(-largest, largest); };
    VertexAttributes attributes;
    attributes.z = any();
    attributes.texture = {any(), any()};
    attributes.normal = {any(), any(), any()};
    return attributes;
}

Triangle triangleOf(SeededRandom &dice, const std::array<LatticePoint, 3> &corners)
{
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.vertices[i].position = corners[i];
        for (std::uint8_t &channel : triangle.vertices[i].colour.channels)
            channel = std::uint8_t(dice.between(0, 255));
    }
    return triangle;
}

/// A random triangle with attributes. Every fourth is a sliver along a random line, every fifth on
/// whole pixels, where vertices and edges meet samples.
Scene anyScene(std::uint32_t seed)
{
    SeededRandom dice(seed);
    const Lattice grid = seed % 5 == 0 ? 256 : 1;
    const auto point = [&]() -> LatticePoint {
        return {dice.between(-4, 24 * 256 / grid) * grid, dice.between(-4, 24 * 256 / grid) * grid};
    };
    std::array<LatticePoint, 3> corners = {point(), point(), point()};
    if (seed % 4 == 0) {
        const Lattice part = dice.between(0, 16);
        corners[1]
            = {corners[0].x + (corners[2].x - corners[0].x) * part / 16 + dice.between(-3, 3),
               corners[0].y + (corners[2].y - corners[0].y) * part / 16 + dice.between(-3, 3)};
    }
    Scene scene;
    scene.frame = frameOf(24, 24);
    scene.triangles = {triangleOf(dice, corners)};
    scene.attributes
        = {{0,
            {anyAttributes(dice, 300 * attributeOne), anyAttributes(dice, 300 * attributeOne),
             anyAttributes(dice, 300 * attributeOne)}}};
    return scene;
}

std::shared_ptr<const TracedScene> tracedBy(Scene scene, const char *form, FillRule rule,
                                            Arithmetic arithmetic = Arithmetic::Exact)
{
    scene.method = form;
    scene.settings = {arithmetic, rule, ByteRounding::Nearest};
    return traceScene(scene);
}

/// Position and R G B z u v N_x N_y N_z of each sample, in order.
struct ChannelValues {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::vector<Quantity> values;

    friend bool operator==(const ChannelValues &, const ChannelValues &) = default;
};

QStringList namesOf(const std::vector<NumberDescription> &numbers)
{
    QStringList names;
    for (const NumberDescription &number : numbers)
        names.append(number.title);
    return names;
}

/// The channels that are not among the names.
QStringList missing(const QStringList &names, QStringList channels)
{
    channels.removeIf([&](const QString &channel) {
        return names.contains(channel)
            || !u"R G B z u v N_x N_y N_z"_s.split(u' ').contains(channel);
    });
    return channels;
}

/// Whether a title is built from a channel's name: "z₀", "z_B", "δz₀₁", "a_Nx".
bool belongsTo(QString title, const QStringList &channels)
{
    static const QRegularExpression decoration(u"^[δΔ]|^[abcABCD]_|[₀₁₂]+$|_?[BT]$"_s);
    title.remove(decoration);
    return std::ranges::any_of(channels, [&](const QString &channel) {
        return title == channel || title == QString(channel).remove(u'_');
    });
}

/// The values of a span's samples in these channels.
std::vector<std::vector<Quantity>> carriedCells(const TracedScene &traced, std::size_t span,
                                                const QStringList &channels)
{
    const QStringList names = namesOf(traced.trace->numbers().sample);
    std::vector<std::vector<Quantity>> cells;
    for (const SampleRecord &sample : traced.trace->samples(span)) {
        std::vector<Quantity> &row = cells.emplace_back();
        for (const QString &channel : channels)
            row.push_back(sample.cells[std::size_t(names.indexOf(channel))]);
    }
    return cells;
}

std::vector<ChannelValues> valuesOf(const TracedScene &traced)
{
    std::vector<ChannelValues> all;
    for (std::size_t span = 0; span < traced.trace->spanCount(); ++span) {
        for (const SampleRecord &sample : traced.trace->samples(span))
            all.push_back({sample.x, sample.y, {sample.cells.end() - 9, sample.cells.end()}});
    }
    return all;
}

} // namespace

/// Interpolation over a triangle (Scan Conversion slides, "Interpolation During Scan Conversion"):
/// the three forms against each other and the truth.
class TestInterpolation : public QObject {
    Q_OBJECT

private slots:
    void theThreeFormsAreEqualInExactArithmetic()
    {
        std::size_t samples = 0;
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(500)); ++seed) {
            const Scene scene = anyScene(seed);
            for (const FillRule rule : rules) {
                const auto bilinear = valuesOf(*tracedBy(scene, forms[0], rule));
                const auto plane = valuesOf(*tracedBy(scene, forms[1], rule));
                const auto barycentric = valuesOf(*tracedBy(scene, forms[2], rule));
                QVERIFY2(bilinear == plane, qPrintable(QString::number(seed)));
                QVERIFY2(bilinear == barycentric, qPrintable(QString::number(seed)));
                samples += bilinear.size();
            }
        }
        QVERIFY(samples > (isSanitized ? 1000U : 20000U));
    }

    void theyAreEqualAcrossTheWholeRange()
    {
        for (std::uint32_t seed = 0; seed < 60; ++seed) {
            SeededRandom dice(seed);
            Scene scene;
            scene.frame = frameOf(9, 9, -4, -4);
            std::array<LatticePoint, 3> corners;
            const Lattice largest = seed % 2 == 0 ? largestCoordinate : largestNarrowCoordinate;
            for (LatticePoint &corner : corners)
                corner = {dice.between(-largest, largest), dice.between(-largest, largest)};
            // Around the frame.
            corners[2]
                = {-corners[0].x / 2 - corners[1].x / 2, -corners[0].y / 2 - corners[1].y / 2};
            scene.triangles = {triangleOf(dice, corners)};
            scene.attributes
                = {{0,
                    {anyAttributes(dice, largestAttribute), anyAttributes(dice, largestAttribute),
                     anyAttributes(dice, largestAttribute)}}};
            const auto bilinear = tracedBy(scene, forms[0], FillRule::HalfOpenColumn);
            const auto plane = tracedBy(scene, forms[1], FillRule::HalfOpenColumn);
            const auto barycentric = tracedBy(scene, forms[2], FillRule::HalfOpenColumn);
            QVERIFY2(valuesOf(*bilinear) == valuesOf(*plane), qPrintable(QString::number(seed)));
            QVERIFY2(valuesOf(*bilinear) == valuesOf(*barycentric),
                     qPrintable(QString::number(seed)));
            QVERIFY(!valuesOf(*plane).empty());
            QCOMPARE(plane->differences.total(), 0);
        }
    }

    void aSegmentIsColouredAlongItself_data()
    {
        QTest::addColumn<std::int64_t>("toX");
        QTest::addColumn<std::int64_t>("toY");
        QTest::newRow("sloped") << std::int64_t(20) << std::int64_t(10);
        QTest::newRow("vertical") << std::int64_t(0) << std::int64_t(16);
        QTest::newRow("horizontal") << std::int64_t(12) << std::int64_t(0);
        QTest::newRow("a point") << std::int64_t(0) << std::int64_t(0);
    }
    void aSegmentIsColouredAlongItself()
    {
        QFETCH(std::int64_t, toX);
        QFETCH(std::int64_t, toY);
        SeededRandom dice(7);
        Scene scene = anyScene(1);
        scene.triangles = {triangleOf(dice,
                                      {latticePixel(2, 3), latticePixel(2 + toX, 3 + toY),
                                       latticePixel(2 + toX / 2, 3 + toY / 2)})};
        const auto expected = valuesOf(*tracedBy(scene, forms[0], FillRule::Closed));
        for (const char *form : forms) {
            const auto closed = tracedBy(scene, form, FillRule::Closed);
            QVERIFY(closed->trace->writtenCount() > 0);
            QCOMPARE(closed->differences.total(), 0);
            const auto halfOpen = tracedBy(scene, form, FillRule::HalfOpenColumn);
            QCOMPARE(halfOpen->trace->setUp(0).rejection, PrimitiveRejection::ZeroArea);
        }
        QVERIFY(valuesOf(*tracedBy(scene, forms[1], FillRule::Closed)) == expected);
    }

    /// Compares the rows' form with the columns' form on the triangle mirrored at the diagonal: of
    /// the channels, nothing else is known of the plane.
    void rowsAreTheColumnsOfTheMirroredTriangle()
    {
        const char *const rows = "interpolate-bilinear-rows";
        std::size_t samples = 0;
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(300)); ++seed) {
            const Scene scene = anyScene(seed);
            Scene mirrored = scene;
            for (Vertex &vertex : mirrored.triangles[0].vertices)
                std::swap(vertex.position.x, vertex.position.y);
            auto byRows = valuesOf(*tracedBy(scene, rows, FillRule::Closed));
            auto byColumns = valuesOf(*tracedBy(mirrored, forms[0], FillRule::Closed));
            for (ChannelValues &sample : byColumns)
                std::swap(sample.x, sample.y);
            const auto isBefore = [](const ChannelValues &a, const ChannelValues &b) {
                return std::pair(a.y, a.x) < std::pair(b.y, b.x);
            };
            std::ranges::sort(byRows, isBefore);
            std::ranges::sort(byColumns, isBefore);
            QVERIFY2(byRows == byColumns, qPrintable(QString::number(seed)));
            samples += byRows.size();
            for (const FillRule rule : {FillRule::Closed, FillRule::TopLeft, FillRule::Open})
                QCOMPARE(tracedBy(scene, rows, rule)->differences.total(), 0);
            for (const Arithmetic arithmetic : {Arithmetic::Float32, Arithmetic::Float64}) {
                const auto rounded = tracedBy(scene, rows, FillRule::Closed, arithmetic);
                QCOMPARE(rounded->differences.count(Difference::Missing), 0);
                QCOMPARE(rounded->differences.count(Difference::Extra), 0);
            }
        }
        QVERIFY(samples > (isSanitized ? 500U : 10000U));
    }

    void attributesAreTheVerticesOwnAtTheVertices()
    {
        SeededRandom dice(3);
        Scene scene = anyScene(1);
        const std::array<LatticePoint, 3> corners
            = {latticePixel(2, 3), latticePixel(20, 5), latticePixel(9, 21)};
        scene.triangles = {triangleOf(dice, corners)};
        for (const char *form : forms) {
            std::size_t found = 0;
            for (const ChannelValues &sample : valuesOf(*tracedBy(scene, form, FillRule::Closed))) {
                for (std::size_t i = 0; i < 3; ++i) {
                    if (latticePixel(sample.x, sample.y) != corners[i])
                        continue;
                    ++found;
                    const VertexAttributes &own = scene.attributes[0].vertices[i];
                    const Colour &colour = scene.triangles[0].vertices[i].colour;
                    QCOMPARE(sample.values[1], Quantity::integer(colour.green()));
                    QCOMPARE(sample.values[3], Quantity::rational(own.z, attributeOne));
                    QCOMPARE(sample.values[5], Quantity::rational(own.texture[1], attributeOne));
                    QCOMPARE(sample.values[8], Quantity::rational(own.normal[2], attributeOne));
                }
            }
            QCOMPARE(found, std::size_t(3));
        }
    }

    void roundingFormsCoverTheSameSamplesAndShowTheirErrors()
    {
        std::array<double, 3> largest32 = {};
        std::array<double, 3> largest64 = {};
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(200)); ++seed) {
            for (std::size_t form = 0; form < 3; ++form) {
                const Scene scene = anyScene(seed);
                const auto exact = valuesOf(*tracedBy(scene, forms[form], FillRule::Closed));
                for (const Arithmetic arithmetic : {Arithmetic::Float32, Arithmetic::Float64}) {
                    const auto traced = tracedBy(scene, forms[form], FillRule::Closed, arithmetic);
                    QCOMPARE(traced->differences.count(Difference::Missing), 0);
                    QCOMPARE(traced->differences.count(Difference::Extra), 0);
                    const auto rounded = valuesOf(*traced);
                    QCOMPARE(rounded.size(), exact.size());
                    auto &largest = arithmetic == Arithmetic::Float32 ? largest32 : largest64;
                    for (std::size_t i = 0; i < exact.size(); ++i) {
                        const double error
                            = std::abs(errorOf(rounded[i].values[3], exact[i].values[3]));
                        if (std::isfinite(error))
                            largest[form] = std::max(largest[form], error);
                    }
                }
            }
        }
        for (std::size_t form = 0; form < 3; ++form) {
            qInfo("%s: z is off by up to %g in float32, %g in float64", forms[form],
                  largest32[form], largest64[form]);
            QVERIFY(largest32[form] > 1e-5);
            QVERIFY(largest64[form] > 0 && largest64[form] < largest32[form]);
        }
    }

    void aSceneFileKeepsTheAttributes()
    {
        Scene scene = anyScene(11);
        scene.method = forms[1];
        scene.settings.fillRule = FillRule::Closed;
        scene.triangles.insert(scene.triangles.begin(), scene.triangles.front());
        scene.attributes.front().triangle = 1;
        const Result<SceneReading> again = readScene(writeScene(scene));
        QVERIFY2(again, again ? "" : qPrintable(again.error().message()));
        QVERIFY(again->scene == scene);

        QByteArray broken = writeScene(scene);
        broken.replace("\"uv\": [[", "\"uv\": [[3, ");
        const Result<SceneReading> failed = readScene(broken);
        QVERIFY(!failed);
        QVERIFY2(failed.error().message().contains(u"primitives[1].uv[0]"_s),
                 qPrintable(failed.error().message()));
    }

    void aTraceHasTheChannelsThatTheSceneGivesAndNoOthers_data()
    {
        QTest::addColumn<bool>("depth");
        QTest::addColumn<bool>("texture");
        QTest::addColumn<bool>("normal");
        QTest::addColumn<QStringList>("channels");
        const QStringList colour = {u"R"_s, u"G"_s, u"B"_s};
        const QStringList z = {u"z"_s};
        const QStringList uv = {u"u"_s, u"v"_s};
        const QStringList n = {u"N_x"_s, u"N_y"_s, u"N_z"_s};
        QTest::newRow("colour alone") << false << false << false << colour;
        QTest::newRow("z") << true << false << false << colour + z;
        QTest::newRow("u v") << false << true << false << colour + uv;
        QTest::newRow("normals") << false << false << true << colour + n;
        QTest::newRow("z and normals") << true << false << true << colour + z + n;
        QTest::newRow("all") << true << true << true << colour + z + uv + n;
    }
    void aTraceHasTheChannelsThatTheSceneGivesAndNoOthers()
    {
        QFETCH(bool, depth);
        QFETCH(bool, texture);
        QFETCH(bool, normal);
        QFETCH(QStringList, channels);
        const Scene whole = anyScene(11);
        Scene scene = whole;
        for (VertexAttributes &vertex : scene.attributes[0].vertices) {
            if (!depth)
                vertex.z = 0;
            if (!texture)
                vertex.texture = {};
            if (!normal)
                vertex.normal = {};
        }
        for (const char *form : forms) {
            for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Float32}) {
                const auto traced = tracedBy(scene, form, FillRule::Closed, arithmetic);
                const auto all = tracedBy(whole, form, FillRule::Closed, arithmetic);
                const TraceNumbers &numbers = traced->trace->numbers();
                const QStringList others = missing(channels, namesOf(all->trace->numbers().sample));
                QVERIFY(missing(namesOf(numbers.sample), channels).isEmpty());
                for (const auto *table : {&numbers.setUp, &numbers.span, &numbers.sample}) {
                    for (const NumberDescription &number : *table)
                        QVERIFY2(!belongsTo(number.title, others), qPrintable(number.title));
                }
                // A carried channel has the same values as when the others are carried too.
                for (std::size_t span = 0; span < traced->trace->spanCount(); ++span)
                    QCOMPARE(carriedCells(*traced, span, channels),
                             carriedCells(*all, span, channels));
            }
        }
    }

    void aCamerasTriangleCarriesColourAloneWhereNoEffectReadsMore()
    {
        Scene scene = sceneOf({triangle3({-1, -0.5, 0}, {1, -0.5, 0}, {0, 1, 0})});
        for (const char *form : forms) {
            scene.method = form;
            const auto traced = traceScene(scene);
            QVERIFY(!traced->shading());
            QVERIFY(traced->trace->writtenCount() > 0);
            const QStringList names = namesOf(traced->trace->numbers().sample);
            for (const char *channel : {"z", "u", "v", "N_x"})
                QVERIFY2(!names.contains(QLatin1String(channel)), channel);
        }
    }
};

PIXELPLUMB_TEST(TestInterpolation)

} // namespace tst_interpolation

#include "tst_interpolation.moc"
