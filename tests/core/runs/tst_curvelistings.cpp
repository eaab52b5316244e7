// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "core/scan/curves/beziersubdivision.h"
#include "core/shade/edgepixels.h"
#include "core/shade/strokes/strokearea.h"
#include "tests/support/framespec.h"
#include "tests/support/listings/listingshapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_curvelistings {

using namespace pixelplumb;

namespace {

using Numbers = std::vector<BigRational>;

std::int64_t whole(const BigRational &value) { return numerator(value).convert_to<std::int64_t>(); }

/// What a Bézier curve's listing calls, by the kernel's functions: of a piece (d, k).
class GivenPieces {
public:
    explicit GivenPieces(const Shape &curve)
        : m_curve(curve)
    {
        m_whole.count = curve.vertices.size();
        for (std::size_t i = 0; i < m_whole.count; ++i) {
            m_whole.x[i] = curve.vertices[i].position.x;
            m_whole.y[i] = curve.vertices[i].position.y;
        }
    }

    ListingState::Given functions() const
    {
        return {{u"undecided"_s,
                 [this](const Numbers &at) {
                     const BezierPiece piece = pieceAt(at);
                     const bool isDecided = piece.depth == deepestCut(m_whole)
                         || BezierDiamonds(piece).verdict(piece) != BezierVerdict::Undecided;
                     return Numbers{isDecided ? 0 : 1};
                 }},
                {u"first"_s,
                 [this](const Numbers &at) {
                     const BezierPiece piece = pieceAt(at);
                     return pixel(piece.isFirst() ? nearest(m_curve.vertices.front())
                                                  : BezierDiamonds(piece).firstPixel());
                 }},
                {u"corner"_s,
                 [this](const Numbers &at) {
                     const BezierPiece piece = pieceAt(at);
                     const BezierDiamonds diamonds(piece);
                     const BezierVerdict verdict = diamonds.verdict(piece);
                     const bool hasCorner = verdict == BezierVerdict::ThroughCorner
                         || verdict == BezierVerdict::Undecided;
                     return pixel(hasCorner ? diamonds.cornerPixel() : std::nullopt);
                 }},
                {u"last"_s, [this](const Numbers &at) {
                     const BezierPiece piece = pieceAt(at);
                     return pixel(piece.isLast() ? nearest(m_curve.vertices.back())
                                                 : BezierDiamonds(piece).lastPixel());
                 }}};
    }

private:
    BezierPiece pieceAt(const Numbers &at) const
    {
        const BigInteger part = numerator(at[1]);
        BezierPiece piece = m_whole;
        for (auto cut = unsigned(whole(at[0])); cut-- > 0;)
            piece = halvesOf(piece)[bit_test(part, cut) ? 1 : 0];
        return piece;
    }
    static std::optional<LatticePoint> nearest(const Vertex &vertex)
    {
        return LatticePoint{floorPixel(vertex.position.x + halfPixel),
                            floorPixel(vertex.position.y + halfPixel)};
    }
    static Numbers pixel(const std::optional<LatticePoint> &place)
    {
        constexpr std::int64_t beyond = std::int64_t(1) << 40;
        return place ? Numbers{place->x, place->y} : Numbers{beyond, beyond};
    }

    const Shape &m_curve;
    BezierPiece m_whole;
};

/// What a stroke's listing calls, by the kernel's functions.
class GivenStroke {
public:
    GivenStroke(const Shape &stroke, const FrameView &frame, Antialiasing antialiasing)
        : m_strip(strokeStripOf(stroke, frame))
        , m_pixels(strokePixels(m_strip.quads, frame))
        , m_pattern(samplePattern(antialiasing))
    {
    }

    ListingState::Given functions() const
    {
        return {{u"share"_s,
                 [this](const Numbers &at) {
                     const auto entries = entriesAt(whole(at[0]), whole(at[1]));
                     if (entries.empty())
                         return Numbers{-1};
                     const auto share = StrokeCoverage(entries, m_strip.quads).share();
                     return Numbers{share.isEmpty ? -1 : int(share.alpha)};
                 }},
                {u"covers"_s,
                 [this](const Numbers &at) {
                     const LatticePoint place
                         = {whole(at[0] * unitsPerPixel), whole(at[1] * unitsPerPixel)};
                     const std::int64_t x = floorPixel(place.x + halfPixel);
                     const std::int64_t y = floorPixel(place.y + halfPixel);
                     const auto entries = entriesAt(x, y);
                     const LatticePoint own = latticePixel(x, y);
                     return Numbers{!entries.empty()
                                            && StrokeCoverage(entries, m_strip.quads)
                                                   .covers({place.x - own.x, place.y - own.y})
                                        ? 1
                                        : 0};
                 }},
                {u"way"_s, [this](const Numbers &sample) {
                     const LatticePoint &place = m_pattern[std::size_t(whole(sample[0])) - 1];
                     return Numbers{inPixels(place.x), inPixels(place.y)};
                 }}};
    }

private:
    std::span<const StrokePixel> entriesAt(std::int64_t x, std::int64_t y) const
    {
        const auto isAt = [&](const StrokePixel &pixel) { return pixel.x == x && pixel.y == y; };
        const auto first = std::ranges::find_if(m_pixels, isAt);
        return {first, std::find_if_not(first, m_pixels.end(), isAt)};
    }

    StrokeStrip m_strip;
    std::vector<StrokePixel> m_pixels;
    std::span<const LatticePoint> m_pattern;
};

/// A line, a circle, an ellipse or a curve of two colours.
Shape oddStroke(int number, std::mt19937 &random)
{
    const Places places(number);
    const LatticePoint from = places.point(random);
    Shape stroke = number % 3 == 0 ? oddRound(number, random)
        : number % 3 == 1          ? lineAtUnits(from, places.point(random))
                                   : oddPath(number, random, ShapeFill::Outline);
    stroke.vertices.back().colour = {{20, 250, 130}};
    return stroke;
}

} // namespace

/// The printed pseudocode of Bézier curves, strokes and texts is executed and compared with their
/// kernels.
class TestCurveListings : public QObject {
    Q_OBJECT

private slots:
    void theListingOfBezierCurvesDrawsWhatItsKernelDraws()
    {
        std::mt19937 random(shapeSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < 60; ++i) {
            const Shape curve = oddPath(i, random, ShapeFill::Outline);
            const auto traced = traceScene(sceneOf(curve, "bezier-subdivision", frameFor(i)));
            ListingNames names;
            setColour(names, curve.vertices[0].colour);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(traced->scene.frame));
            const GivenPieces given(traced->primitives.shape(0));
            run.state().setGiven(given.functions());
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(nameOf(curve) + departure));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 300);
    }

    void theListingOfStrokesDrawsWhatItsKernelDraws_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        for (const Antialiasing antialiasing : {Antialiasing::None, Antialiasing::Area,
                                                Antialiasing::Samples4, Antialiasing::Samples16})
            QTest::addRow("kind %d", int(antialiasing)) << antialiasing;
    }
    void theListingOfStrokesDrawsWhatItsKernelDraws()
    {
        QFETCH(Antialiasing, antialiasing);
        std::mt19937 random(shapeSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < 6; ++i) { // some seconds each
            const Shape stroke = oddStroke(i, random);
            Scene scene = sceneOf(stroke, "stroke-coverage", frameFor(i));
            scene.frame.background = {{30, 60, 90}};
            scene.appearance.antialiasing = antialiasing;
            const auto traced = traceScene(scene);
            if (traced->trace->setUp(0).rejection)
                continue;
            const FrameView frame = traced->truth.view();
            const SampleBox box = frameBox(scene.frame);
            const Shape &seen = traced->primitives.shape(0);
            const Vertex &first = seen.vertices.front();
            const Vertex &last
                = seen.kind == PrimitiveKind::Line ? seen.vertices.back() : seen.vertices.front();
            ListingNames names = {{u"x_first"_s, box.firstX},
                                  {u"x_last"_s, box.endX - 1},
                                  {u"y_first"_s, box.firstY},
                                  {u"y_last"_s, box.endY - 1},
                                  {u"x₀"_s, inPixels(first.position.x)},
                                  {u"y₀"_s, inPixels(first.position.y)},
                                  {u"x₁"_s, inPixels(last.position.x)},
                                  {u"y₁"_s, inPixels(last.position.y)},
                                  {u"n"_s, samplePattern(antialiasing).size()}};
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const QString letter = channelLetters[channel];
                names[letter + u'₀'] = first.colour.channels[channel];
                names[letter + u'₁'] = last.colour.channels[channel];
            }
            const FrameBuffer background(scene.frame);
            ListingRun::Pixels under;
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                for (std::int64_t y = box.firstY; y < box.endY; ++y) {
                    const QRgb colour = under[{x, y}] = *background.view().at(x, y);
                    for (std::size_t k = 1; k <= samplePattern(antialiasing).size(); ++k) {
                        const QString at = u"[%1,%2,%3]"_s.arg(k).arg(x).arg(y);
                        names[u'R' + at] = qRed(colour);
                        names[u'G' + at] = qGreen(colour);
                        names[u'B' + at] = qBlue(colour);
                    }
                }
            }
            ListingRun run(pseudocodeOf(*traced, 0), names, box);
            const GivenStroke given(seen, frame, traced->strokeAntialiasing());
            run.state().setGiven(given.functions());
            run.state().setUnder(under);
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(nameOf(stroke) + departure));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 10);
    }

    /// The contours of the glyphs are given; what fills them is run.
    void theListingOfTextsDrawsWhatItsKernelDraws()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
        std::size_t drawn = 0;
        const Method &method = *methodNamed(u"text-outlines"_s);
        for (int i = 0; i < 24; ++i) {
            Shape text;
            text.kind = PrimitiveKind::Text;
            text.fill = ShapeFill::NonZero;
            text.vertices = {{{100 * i - 700, 37 * i}, {{200, 100, 50}}}};
            text.text = "&8g";
            text.textHeight = (6 + i) * unitsPerPixel;
            Scene scene = sceneOf(text, "text-outlines", frameFor(i));
            const auto listed = listedArithmetics(method);
            scene.settings.arithmetic = listed[std::size_t(i) % listed.size()];
            scene.settings = method.adapted(scene.settings);
            const auto traced = traceScene(scene);
            if (traced->trace->setUp(0).rejection)
                continue;
            ListingNames names = setUpNames(*traced);
            names[u"non-zero"_s] = 1;
            setColour(names, text.vertices[0].colour);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(scene.frame));
            run.setItems(itemsOf(sharedOutlinesOf(traced->primitives.shape(0))->contours.edges));
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(departure));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 300);
    }
};

PIXELPLUMB_TEST(TestCurveListings)

} // namespace tst_curvelistings

#include "tst_curvelistings.moc"
