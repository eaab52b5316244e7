// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "core/shade/shadedchoice.h"
#include "tests/support/listings/giveneffects.h"
#include "tests/support/listings/listingscenes.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_effectlistings {

using namespace pixelplumb;

namespace {

using Number = BigRational;
Number inUnits(std::int64_t units) { return Number(units, attributeOne); }

Number rounded(const Number &value, Arithmetic arithmetic)
{
    return arithmetic == Arithmetic::Float32 ? Number(value.convert_to<float>())
        : arithmetic == Arithmetic::Float64  ? Number(value.convert_to<double>())
                                             : value;
}

/// What the vertices of a triangle carry, by the names of the listing.
ListingNames namesOf(const TracedScene &traced, std::size_t index)
{
    const Primitives &primitives = traced.primitives;
    const Triangle &triangle = primitives.triangles[index];
    const Arithmetic arithmetic = traced.settings.arithmetic;
    const ShadedTriangle shaded{triangle, primitives.attributesOf(index)};
    ListingNames names;
    constexpr std::array<QChar, 3> digits = {u'₀', u'₁', u'₂'};
    const QStringList values = {u"R"_s, u"G"_s,   u"B"_s,   u"A"_s,   u"z"_s,   u"q"_s,   u"u"_s,
                                u"v"_s, u"N_x"_s, u"N_y"_s, u"N_z"_s, u"p_x"_s, u"p_y"_s, u"p_z"_s};
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &at = triangle.vertices[i].position;
        names[QString(u'x') + digits[i]] = Number(at.x, unitsPerPixel);
        names[QString(u'y') + digits[i]] = Number(at.y, unitsPerPixel);
        names[QString(u'P') + digits[i]] = i;
        names[QString(u'w') + digits[i]] = rounded(inUnits(shaded.wAt(i)), arithmetic);
        for (std::size_t channel = 0; channel < shadedChannelCount; ++channel) {
            const std::int64_t units = shaded.valueAt(i, channelAt(channel));
            names[values[qsizetype(channel)] + digits[i]]
                = isLevel(channelAt(channel)) ? Number(units) : rounded(inUnits(units), arithmetic);
        }
    }
    Triangle sorted = triangle;
    for (std::size_t i = 0; i < 3; ++i)
        sorted.vertices[i] = triangle.vertices[std::size_t(sortedByColumn(triangle)[i])];
    names[u"S"_s]
        = Number(BigInteger(doubledArea(sorted)), BigInteger(unitsPerPixel * unitsPerPixel));
    names[u"h"_s]
        = hasHorizon(triangle, primitives.attributesOf(index), primitives.appearance) ? 1 : 0;
    names[u"n"_s] = samplePattern(traced.antialiasing()).size();
    if (arithmetic == Arithmetic::Exact)
        names[u"fractions"_s] = 1;
    return names;
}

/// What is drawn so far, and what each sample holds: z_near[…] and R[…], G[…], B[…].
struct Picture {
    explicit Picture(const TracedScene &traced)
    {
        const FrameBuffer frame(traced.scene.frame);
        const FrameView view = frame.view();
        const std::size_t samples = samplePattern(traced.antialiasing()).size();
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
                const QRgb colour = *view.at(x, y);
                under[{x, y}] = colour;
                const Number farthest = Number(BigInteger(1) << 100);
                const QString place = u"%1,%2]"_s.arg(x).arg(y);
                if (samples == 0)
                    held[u"z_near["_s + place] = farthest;
                for (std::size_t k = 0; samples > 0 && k <= samples; ++k) {
                    const QString at = u"[%1,"_s.arg(k) + place;
                    held[u"z_near"_s + at] = farthest;
                    held[u'R' + at] = qRed(colour);
                    held[u'G' + at] = qGreen(colour);
                    held[u'B' + at] = qBlue(colour);
                }
            }
        }
    }
    /// Draws on, by the listing of a triangle.
    template <class N>
    void draw(const TracedScene &traced, std::size_t index, const Pseudocode &code)
    {
        ListingNames names = namesOf(traced, index);
        names.insert(held.begin(), held.end());
        ListingRun run(code, names, frameBox(traced.scene.frame));
        TriangleEffects effects(*traced.shading());
        GivenEffects<N> given(traced, index, effects.at(index).depth);
        run.state().setGiven(given.functions());
        run.state().setUnder(under);
        run.computeIn(traced.settings.arithmetic);
        run.run();
        for (auto &[name, value] : held)
            value = run.state().names().at(name);
        for (const auto &[place, colour] : run.pixels())
            under[place] = drawn[place] = colour;
    }

    ListingRun::Pixels under, drawn;
    ListingNames held;
};

/// Why the listings draw another picture; empty if they do not.
QString departureOfAll(const TracedScene &traced)
{
    Picture picture(traced);
    for (std::size_t index = 0; index < traced.primitives.triangles.size(); ++index) {
        const SetUpRecord setUp = traced.trace->setUp(index);
        if (setUp.zeroArea && traced.settings.fillRule != FillRule::Closed)
            continue;
        const Pseudocode code = pseudocodeOf(traced, index);
        try {
            switch (traced.settings.arithmetic) {
            case Arithmetic::Float32:
                picture.draw<FloatShading<float>>(traced, index, code);
                break;
            case Arithmetic::Float64:
                picture.draw<FloatShading<double>>(traced, index, code);
                break;
            default:
                picture.draw<ExactShading<Int256>>(traced, index, code);
            }
        } catch (const ListingFault &fault) {
            return u"triangle %1: "_s.arg(index) + QString::fromUtf8(fault.what());
        }
    }
    return differenceOf(picture.drawn, traced);
}

/// A random scene as its method draws it.
Scene effectScene(std::uint64_t seed, EffectHardship hardship, const Method &method,
                  Arithmetic arithmetic)
{
    const EffectScene random = randomEffectScene(seed, hardship);
    Scene scene;
    scene.frame = random.frame;
    scene.frame.width = std::min(scene.frame.width, 11);
    scene.frame.height = std::min(scene.frame.height, 11);
    scene.appearance = random.primitives.appearance;
    if (seed % 3 == 0)
        scene.appearance.shading = seed % 2 == 0 ? Shading::Gouraud : Shading::Flat;
    scene.triangles = random.primitives.triangles;
    scene.attributes = random.primitives.attributes;
    const Lattice centre = sampleOffset(scene.frame);
    for (Triangle &triangle : scene.triangles)
        for (Vertex &vertex : triangle.vertices)
            vertex.position = {vertex.position.x + centre, vertex.position.y + centre};
    scene.method = method.id.toStdString();
    scene.settings.arithmetic = arithmetic;
    scene.settings.fillRule = method.fillRules[seed % method.fillRules.size()];
    return scene;
}

} // namespace

/// The printed pseudocode of triangles with effects is executed, triangle by triangle, and compared
/// with the picture of the kernels.
class TestEffectListings : public QObject {
    Q_OBJECT

private slots:
    void listingsWithEffectsDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<const Method *>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<EffectHardship>("hardship");
        for (const Method &method : methods()) {
            if (method.shadedPseudocode.empty())
                continue;
            for (const Arithmetic arithmetic : listedArithmetics(method)) {
                for (const EffectHardship hardship : allEffectHardships) {
                    if (method.shadesIn(arithmetic))
                        QTest::addRow("%s, %s, %s", qPrintable(method.id),
                                      std::string(nameOf(arithmetic)).c_str(),
                                      qPrintable(nameOf(hardship)))
                            << &method << arithmetic << hardship;
                }
            }
        }
    }
    void listingsWithEffectsDrawWhatTheirKernelsDraw()
    {
        QFETCH(const Method *, method);
        QFETCH(Arithmetic, arithmetic);
        QFETCH(EffectHardship, hardship);
        std::size_t run = 0;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const auto traced = traceScene(effectScene(seed, hardship, *method, arithmetic));
            // At 2²⁰ px float32 does not hold the samples' ways, which the kernel adds before it
            // rounds.
            const bool isTooFar = hardship == EffectHardship::FarAway
                && arithmetic == Arithmetic::Float32
                && !samplePattern(traced->antialiasing()).empty();
            if (!traced->shading() || isTooFar)
                continue;
            const QString departure = departureOfAll(*traced);
            QVERIFY2(departure.isEmpty(), qPrintable(u"seed %1: %2"_s.arg(seed).arg(departure)));
            ++run;
        }
        QVERIFY(run > 0);
    }
};

PIXELPLUMB_TEST(TestEffectListings)

} // namespace tst_effectlistings

#include "tst_effectlistings.moc"
