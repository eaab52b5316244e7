// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/attributecase.h"
#include "core/check/casecoordinates.h"
#include "core/check/effectcase.h"
#include "core/check/linecase.h"
#include "core/check/shapecase.h"
#include "core/scene/text/coordinatetext.h"

#include <QFile>

#include <limits>

namespace pixelplumb {

namespace {

constexpr qint64 largestFact = std::numeric_limits<qint64>::max();

constexpr std::array<std::pair<const char *, HardCaseKind>, 10> kindNames
    = {{{"triangle", HardCaseKind::Triangle},
        {"mesh", HardCaseKind::Mesh},
        {"sequence", HardCaseKind::Sequence},
        {"translation", HardCaseKind::Translation},
        {"invalid", HardCaseKind::Invalid},
        {"line", HardCaseKind::Line},
        {"circle", HardCaseKind::Circle},
        {"polygon", HardCaseKind::Polygon},
        {"attributes", HardCaseKind::Attributes},
        {"effects", HardCaseKind::Effects}}};

constexpr std::array<std::pair<const char *, FillRule>, 4> ruleNames
    = {{{"closed", FillRule::Closed},
        {"half_open_column", FillRule::HalfOpenColumn},
        {"top_left", FillRule::TopLeft},
        {"open", FillRule::Open}}};

/// The colours of a triangle whose case specifies none.
constexpr std::array<Colour, 3> defaultColours
    = {Colour{{255, 0, 0}}, Colour{{0, 255, 0}}, Colour{{0, 0, 255}}};

/// Reads one case; the JsonReader keeps errors. Keys that no check needs are ignored.
class HardCaseReader {
public:
    explicit HardCaseReader(JsonReader &json)
        : m_json(json)
    {
    }

    HardCase read(const JsonNode &node)
    {
        m_case.id = m_json.string(member(node, "id"));
        m_case.kind = choice(m_json, member(node, "kind"), kindNames);
        m_case.stresses = member(node, "stresses").toString();
        switch (m_case.kind) {
        case HardCaseKind::Triangle:
        case HardCaseKind::Translation:
            readCanvas(node);
            m_case.triangles = {triangle(member(node, "vertices"), node)};
            readOffsets(node);
            readFacts(member(node, "expected"));
            readPoints(node);
            break;
        case HardCaseKind::Mesh:
            readCanvas(node);
            readMesh(node);
            readFacts(member(node, "expected"));
            break;
        case HardCaseKind::Sequence:
            readCanvas(node);
            for (const JsonNode &frame : m_json.array(member(node, "frames")))
                m_case.triangles.push_back(triangle(frame, node));
            readFacts(member(node, "expected"));
            break;
        case HardCaseKind::Invalid:
            readInvalidVertices(member(node, "vertices_text"));
            break;
        case HardCaseKind::Line:
            readLineCase(m_json, node, m_case);
            break;
        case HardCaseKind::Circle:
            readCanvas(node);
            readCircleCase(m_json, node, m_coordinates, m_case);
            readFacts(member(node, "expected"));
            break;
        case HardCaseKind::Polygon:
            readCanvas(node);
            readPolygonCase(m_json, node, m_coordinates, m_case);
            readFacts(member(node, "expected"));
            break;
        case HardCaseKind::Attributes:
            readCanvas(node);
            m_case.triangles = {triangle(member(node, "vertices"), node)};
            readAttributes(m_json, node, m_case);
            readFacts(member(node, "expected"));
            readPoints(node);
            break;
        case HardCaseKind::Effects:
            readCanvas(node);
            readEffectCase(m_json, node, m_coordinates, m_case);
            readFacts(member(node, "expected"));
            break;
        }
        return std::move(m_case);
    }

private:
    void readCanvas(const JsonNode &node)
    {
        m_coordinates.readCanvas(node);
        m_coordinates.readScale(node);
    }

    /// Uses the colours of the case, if it has any.
    Triangle triangle(const JsonNode &vertices, const JsonNode &node)
    {
        Triangle triangle;
        const JsonNode colours = member(node, "colours");
        const std::vector<JsonNode> corners = m_json.array(vertices, 3);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vertex &vertex = triangle.vertices[corner];
            vertex.position = m_coordinates.position(corners[corner]);
            vertex.colour = defaultColours[corner];
            if (colours.isMissing())
                continue;
            const std::vector<JsonNode> channels = m_json.array(colours[qsizetype(corner)], 3);
            for (std::size_t channel = 0; channel < 3; ++channel)
                vertex.colour.channels[channel]
                    = std::uint8_t(m_json.integer(channels[channel], 0, 255));
        }
        return triangle;
    }

    void readMesh(const JsonNode &node)
    {
        std::vector<LatticePoint> positions;
        for (const JsonNode &vertex : m_json.array(member(node, "vertices")))
            positions.push_back(m_coordinates.position(vertex));
        for (const JsonNode &corners : m_json.array(member(node, "triangles"))) {
            Triangle triangle;
            const std::vector<JsonNode> indices = m_json.array(corners, 3);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const qint64 index
                    = m_json.integer(indices[corner], 0, qint64(positions.size()) - 1);
                if (m_json.hasFailed())
                    return;
                triangle.vertices[corner] = {positions[std::size_t(index)], defaultColours[corner]};
            }
            m_case.triangles.push_back(triangle);
        }
    }

    void readOffsets(const JsonNode &node)
    {
        if (m_case.kind != HardCaseKind::Translation)
            return;
        for (const JsonNode &offset : m_json.array(member(node, "offsets_px"))) {
            const CasePixel moved = pixel(m_json, offset);
            if (!staysWithinRange(moved[0], moved[1])) {
                m_json.fail(offset, u"the case leaves ±%1 px"_s.arg(largestPixel),
                            "a smaller offset");
            }
            m_case.offsets.push_back(moved);
        }
    }

    bool staysWithinRange(qint64 right, qint64 up) const
    {
        const LatticePoint corner
            = latticePixel(m_case.canvas.firstColumn + right, m_case.canvas.firstRow + up);
        bool within = isWithinRange(corner);
        for (const Vertex &vertex : m_case.triangles.front().vertices) {
            const LatticePoint moved = {vertex.position.x + right * unitsPerPixel,
                                        vertex.position.y + up * unitsPerPixel};
            within = within && isWithinRange(moved);
        }
        return within;
    }

    std::optional<std::int64_t> count(const JsonNode &node)
    {
        if (node.isMissing())
            return std::nullopt;
        return m_json.integer(node, 0, largestFact);
    }

    void readFacts(const JsonNode &expected)
    {
        for (const auto &[name, rule] : ruleNames) {
            const JsonNode node = member(expected, name);
            if (node.isMissing())
                continue;
            ExpectedFacts &facts = m_case.facts[rule];
            facts.pixelCount = count(member(node, "count"));
            facts.spanHash = member(node, "span_sha").toString().toLatin1();
            facts.pixelHash = member(node, "sha").toString().toLatin1();
            facts.colourHash = member(node, "rgb_sha").toString().toLatin1();
            facts.toggles = count(member(node, "toggles"));
            facts.distinctPictures = count(member(node, "distinct_pictures"));
            if (const JsonNode sums = member(node, "sum8"); !sums.isMissing())
                facts.channelSums = integers(sums);
            if (const JsonNode counts = member(node, "counts"); !counts.isMissing()) {
                for (const JsonNode &frame : m_json.array(counts))
                    facts.frameCounts.push_back(m_json.integer(frame, 0, largestFact));
            }
            const JsonNode histogram = member(node, "histogram");
            const QStringList times = histogram.keys();
            for (const QString &key : times)
                facts.histogram[key.toInt()] = m_json.integer(histogram[key], 0, largestFact);
        }
    }

    std::array<std::int64_t, 3> integers(const JsonNode &node)
    {
        const std::vector<JsonNode> elements = m_json.array(node, 3);
        std::array<std::int64_t, 3> values = {};
        for (std::size_t index = 0; index < 3; ++index)
            values[index] = m_json.integer(elements[index], -largestFact, largestFact);
        return values;
    }

    void readPoints(const JsonNode &node)
    {
        const JsonNode points = member(node, "points");
        if (points.isMissing())
            return;
        for (const JsonNode &each : m_json.array(points)) {
            ExpectedPoint point;
            point.x = m_json.integer(member(each, "x"), -largestPixel, largestPixel);
            point.y = m_json.integer(member(each, "y"), -largestPixel, largestPixel);
            for (const auto &[name, rule] : ruleNames) {
                const JsonNode covered = member(member(each, "in"), name);
                if (!covered.isMissing())
                    point.covered[rule] = covered.isTrue();
            }
            const std::vector<JsonNode> exact = m_json.array(member(each, "rgb"), 3);
            for (std::size_t channel = 0; channel < 3; ++channel)
                point.exactColour[channel] = m_json.string(exact[channel]);
            point.roundedColour = integers(member(each, "rgb8"));
            point.values = readExpectedValues(m_json, member(each, "values"));
            m_case.points.push_back(point);
        }
    }

    void readInvalidVertices(const JsonNode &vertices)
    {
        for (const JsonNode &vertex : m_json.array(vertices, 3)) {
            for (const JsonNode &text : m_json.array(vertex, 2)) {
                const Result<SnappedNumber> snapped = parseCoordinate(m_json.string(text));
                if (!snapped && m_case.refusal.isEmpty())
                    m_case.refusal = snapped.error().found;
            }
        }
    }

    JsonReader &m_json;
    HardCase m_case;
    CaseCoordinates m_coordinates{m_json, m_case};
};

} // namespace

Result<std::vector<HardCase>> readHardCases(const QByteArray &text)
{
    JsonReader json(text);
    std::vector<HardCase> cases;
    if (!json.hasFailed() && !json.root().isObject())
        json.fail(json.root(), describe(json.root()), "an object");
    if (!json.hasFailed())
        json.integer(member(json.root(), "version"), 1, 1);
    if (!json.hasFailed()) {
        for (const JsonNode &node : json.array(member(json.root(), "cases"))) {
            cases.push_back(HardCaseReader(json).read(node));
            if (json.hasFailed())
                break;
        }
    }
    if (json.hasFailed())
        return json.error();
    return cases;
}

Result<std::vector<HardCase>> builtInHardCases()
{
    QFile file(":/cases/hard_cases.json");
    if (!file.open(QIODevice::ReadOnly))
        return std::vector<HardCase>();
    return readHardCases(file.readAll());
}

} // namespace pixelplumb
