// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/shapecase.h"

#include "core/check/casefacts.h"
#include "core/methods/words/rejectiontext.h"

#include <span>

namespace pixelplumb {

namespace {

/// The colour of all shapes of the cases.
constexpr Colour shapeColour = {{200, 100, 50}};

constexpr std::array<std::pair<const char *, ShapeFill>, 3> fillNames
    = {{{"even-odd", ShapeFill::EvenOdd},
        {"non-zero", ShapeFill::NonZero},
        {"outline", ShapeFill::Outline}}};
/// A polygon must be filled.
constexpr std::span insideFillNames = std::span(fillNames).first<2>();

void readPolygon(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                 Shape &polygon)
{
    for (const JsonNode &contour : json.array(node)) {
        const std::vector<JsonNode> vertices = json.array(contour);
        if (vertices.size() < 3 && !json.hasFailed())
            json.fail(contour, u"%1 vertices"_s.arg(vertices.size()), "3 or more");
        if (!polygon.vertices.empty())
            polygon.laterContours.push_back(polygon.vertices.size());
        for (const JsonNode &vertex : vertices)
            polygon.vertices.push_back({coordinates.position(vertex), shapeColour});
    }
    if (polygon.vertices.empty() && !json.hasFailed())
        json.fail(node, "no contour", "1 or more");
}

/// How many pixels the shapes cover once, twice, … when each is drawn alone.
std::map<int, std::int64_t> coverageHistogram(const HardCase &hardCase,
                                              const ScanSettings &settings, const Drawing &drawing)
{
    CoverageTimes times;
    for (const Shape &shape : hardCase.shapes) {
        CasePicture picture(hardCase.canvas, settings.fillRule);
        picture.draw(Primitives{{}, {shape}}, settings, drawing);
        addCoverage(times, picture);
    }
    return histogramOf(times);
}

} // namespace

void readCircleCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                    HardCase &hardCase)
{
    const LatticePoint centre = coordinates.position(member(node, "centre"));
    const JsonNode radiusNode = member(node, "radius");
    const Lattice radius = coordinates.coordinate(radiusNode);
    const LatticePoint corner = {centre.x + radius, centre.y + radius};
    if (!json.hasFailed() && (radius < 0 || !isWithinRange(corner)))
        json.fail(radiusNode, describe(radiusNode),
                  u"0 or more, and a circle within ±%1 px"_s.arg(largestPixel));
    Shape circle;
    circle.kind = PrimitiveKind::Circle;
    circle.fill = choice(json, member(node, "fill"), fillNames);
    circle.vertices = {{centre, shapeColour}, {corner, shapeColour}};
    hardCase.shapes = {circle};
}

void readPolygonCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                     HardCase &hardCase)
{
    const JsonNode polygonsNode = member(node, "polygons");
    const ShapeFill fill = choice(json, member(node, "fill"), insideFillNames);
    for (const JsonNode &each : json.array(polygonsNode)) {
        Shape polygon;
        polygon.kind = PrimitiveKind::Polygon;
        polygon.fill = fill;
        readPolygon(json, each, coordinates, polygon);
        hardCase.shapes.push_back(std::move(polygon));
    }
    if (hardCase.shapes.empty() && !json.hasFailed())
        json.fail(polygonsNode, "no polygon", "1 or more");
}

QStringList shapeShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                            const Drawing &drawing)
{
    const auto drawnBy = [&](const Drawing &by) {
        CasePicture picture(hardCase.canvas, settings.fillRule);
        picture.draw(Primitives{{}, hardCase.shapes}, settings, by);
        return picture;
    };
    const CasePicture picture = drawnBy(drawing);
    QStringList shortfalls;
    if (hardCase.displacements.isEmpty()) {
        const ExpectedFacts &facts = hardCase.facts.at(settings.fillRule);
        comparePicture(shortfalls, facts, picture);
        if (!facts.histogram.empty())
            compareHistogram(shortfalls, coverageHistogram(hardCase, settings, drawing),
                             facts.histogram);
        if (shortfalls.isEmpty())
            return shortfalls;
    }
    // Facts show that something is wrong; only the truth shows how many pixels.
    const DifferenceCounts differences = differencesBetween(picture, drawnBy(drawTruly));
    if (differences.total() > 0)
        shortfalls.prepend(differences.message());
    return shortfalls;
}

QString shapeRefusal(const HardCase &hardCase, const ScanSettings &settings, const Method &method)
{
    const WrittenFrame frame(hardCase.canvas);
    const Run run(&method, {{}, hardCase.shapes}, settings, frame.view());
    const std::unique_ptr<ScanTrace> trace = run.trace(frame.view());
    for (std::size_t shape = 0; shape < trace->primitiveCount(); ++shape) {
        const std::optional<Rejection> rejection = trace->setUp(shape).rejection;
        if (rejection == PrimitiveRejection::NotConvex
            || rejection == PrimitiveRejection::SelfCrossing)
            return rejectionText(*rejection);
    }
    return {};
}

} // namespace pixelplumb
