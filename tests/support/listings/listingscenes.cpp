// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingscenes.h"

#include "core/scan/choicenames.h"
#include "tests/support/framespec.h"

#include <QStringList>

#include <array>

namespace pixelplumb {

namespace {

constexpr std::array<QChar, 3> digits = {u'₀', u'₁', u'₂'};

FrameSpec oddFrame(int number)
{
    FrameSpec frame = number % 4 == 3 ? frameOf(9, 7, 2, 1)
        : number % 4 == 1             ? frameOf(14, 13, -3, -5)
                                      : frameOf(14, 13);
    frame.origin = number % 5 == 4 ? FrameOrigin::TopLeft : FrameOrigin::BottomLeft;
    return frame;
}

} // namespace

BigRational inPixels(Lattice units) { return BigRational(units, unitsPerPixel); }

Scene oddTriangleScene(int number, std::mt19937 &random)
{
    const int kind = number % 12;
    const Lattice step = kind < 5 ? unitsPerPixel : kind < 8 ? 37 : kind == 8 ? 1 : 128;
    const Lattice reach = kind == 8 ? 2 * unitsPerPixel : 18 * unitsPerPixel;
    std::uniform_int_distribution<Lattice> place(0, reach / step);
    std::uniform_int_distribution<Lattice> corner(-8, 8);
    std::uniform_int_distribution<int> level(0, 255);
    Scene scene;
    scene.frame = oddFrame(number);
    const LatticePoint start
        = {corner(random) * unitsPerPixel / 2, corner(random) * unitsPerPixel / 2};
    Triangle triangle;
    for (Vertex &vertex : triangle.vertices) {
        vertex.position = {start.x + place(random) * step, start.y + place(random) * step};
        for (auto &channel : vertex.colour.channels)
            channel = std::uint8_t(level(random));
    }
    auto &[a, b, c] = triangle.vertices;
    if (kind == 2)
        b.position.x = a.position.x;
    else if (kind == 3)
        c.position.y = b.position.y;
    else if (kind == 4)
        c.position = {2 * b.position.x - a.position.x, 2 * b.position.y - a.position.y};
    else if (kind == 7)
        c.position = {b.position.x + 5, b.position.y + 3};
    else if (kind == 11)
        c.position.x = b.position.x = a.position.x;
    scene.triangles = {triangle};
    return scene;
}

ListingNames vertexNames(const Triangle &triangle, const FrameSpec &frame)
{
    const Lattice centre = sampleOffset(frame);
    ListingNames names;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex &vertex = triangle.vertices[i];
        names[QString(u'x') + digits[i]] = inPixels(vertex.position.x - centre);
        names[QString(u'y') + digits[i]] = inPixels(vertex.position.y - centre);
        for (std::size_t channel = 0; channel < 3; ++channel)
            names[QString(channelLetters[channel]) + digits[i]] = vertex.colour.channels[channel];
    }
    return names;
}

ListingNames setUpNames(const TracedScene &traced)
{
    ListingNames names;
    const SetUpRecord setUp = traced.trace->setUp(0);
    const std::vector<NumberDescription> &numbers = traced.trace->numbers().setUp;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Quantity &value = setUp.cells[i];
        if (value.isRational())
            names[numbers[i].title]
                = BigRational(BigInteger(value.numerator()), BigInteger(value.denominator()));
        else if (!value.isNone() && value.isFinite())
            names[numbers[i].title] = BigRational(value.toDouble());
    }
    return names;
}

SampleBox frameBox(const FrameSpec &frame)
{
    return {frame.firstColumn, frame.firstColumn + frame.width, frame.firstRow,
            frame.firstRow + frame.height};
}

ListingRun::Pixels pixelsOf(const TracedScene &traced)
{
    ListingRun::Pixels pixels;
    const ScanTrace &trace = *traced.trace;
    for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
        const PixelChange &change = trace.changes()[sample];
        if (change.isWritten())
            pixels[{change.x, change.y}] = change.after;
    }
    return pixels;
}

std::vector<Arithmetic> listedArithmetics(const Method &method)
{
    std::vector<Arithmetic> listed;
    for (const Arithmetic arithmetic :
         {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64}) {
        if (method.supports(arithmetic))
            listed.push_back(arithmetic);
    }
    return listed;
}

QString differenceOf(const ListingRun::Pixels &pixels, const TracedScene &traced)
{
    const ListingRun::Pixels expected = pixelsOf(traced);
    if (pixels == expected)
        return {};
    QStringList different;
    const auto compare = [&](const ListingRun::Pixels &ones, const ListingRun::Pixels &others,
                             const QString &word) {
        for (const auto &[place, colour] : ones) {
            const auto other = others.find(place);
            if (other == others.end() || other->second != colour)
                different.append(u"%1 (%2, %3) %4"_s.arg(word)
                                     .arg(place.first)
                                     .arg(place.second)
                                     .arg(colour & 0xFFFFFF, 6, 16, QChar(u'0')));
        }
    };
    compare(pixels, expected, u"listing"_s);
    compare(expected, pixels, u"kernel"_s);
    QStringList vertices;
    for (const Triangle &triangle : traced.scene.triangles)
        for (const Vertex &vertex : triangle.vertices)
            vertices.append(u"(%1, %2)/256"_s.arg(vertex.position.x).arg(vertex.position.y));
    return vertices.join(u' ') + u": "_s + different.join(u", "_s);
}

QString departureOf(ListingRun &run, const TracedScene &traced)
{
    run.computeIn(traced.scene.settings.arithmetic);
    try {
        run.run();
    } catch (const ListingFault &fault) {
        return QString::fromUtf8(fault.what());
    }
    return differenceOf(run.pixels(), traced);
}

} // namespace pixelplumb
