// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingshapes.h"

#include "tests/support/framespec.h"

namespace pixelplumb {

FrameSpec frameFor(int number)
{
    FrameSpec frame = number % 4 == 3 ? frameOf(9, 7, 2, 1)
        : number % 4 == 1             ? frameOf(14, 13, -3, -5)
                                      : frameOf(14, 13);
    frame.origin = number / 3 % 2 == 1 ? FrameOrigin::TopLeft : FrameOrigin::BottomLeft;
    return frame;
}

void setColour(ListingNames &names, const Colour &colour)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
        names[u"colour "_s + QString(channelLetters[channel])] = colour.channels[channel];
}

Shape oddRound(int number, std::mt19937 &random)
{
    const Places places(number);
    const std::int64_t largest = number % 7 == 0 ? 1 : number % 7 == 1 ? 25 : 7;
    const Lattice radius = places.between(0, largest, random);
    const LatticePoint centre = places.point(random);
    return ellipseAtUnits(centre, radius,
                          number % 2 == 0 ? radius : places.between(0, largest, random));
}

Shape oddPolygon(int number, std::mt19937 &random, ShapeFill fill)
{
    const Places places(number);
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = fill;
    const int count = 3 + number % 6;
    for (int i = 0; i < count; ++i) {
        LatticePoint point = places.point(random);
        if (i > 0 && number % 4 == 1)
            point.y = polygon.vertices.back().position.y;
        if (i > 0 && number % 4 == 2)
            point.x = polygon.vertices.back().position.x;
        polygon.vertices.push_back({point, {{200, 100, 50}}});
    }
    return polygon;
}

Shape oddPath(int number, std::mt19937 &random, ShapeFill fill)
{
    const Places places(number);
    std::vector<LatticePoint> controls;
    for (int i = 0; i < 3 + number % 2; ++i)
        controls.push_back(places.point(random));
    Shape path = bezierAt(controls);
    path.fill = fill;
    return path;
}

std::vector<ListingRun::Item> itemsOf(const std::vector<ContourEdge> &edges)
{
    std::vector<ListingRun::Item> items;
    for (const ContourEdge &edge : edges)
        items.push_back({inPixels(edge.from.x), inPixels(edge.from.y), inPixels(edge.to.x),
                         inPixels(edge.to.y)});
    return items;
}

QString message(int number, const QString &departure)
{
    return departure.isEmpty()
        ? departure
        : u"seed %1, shape %2: %3"_s.arg(shapeSeed).arg(number).arg(departure);
}

} // namespace pixelplumb
