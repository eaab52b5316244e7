// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/effectcase.h"

#include "core/check/casefacts.h"
#include "core/scene/fields/partreader.h"

namespace pixelplumb {

namespace {

constexpr Colour white = {{255, 255, 255}};

/// A method that draws effects, and whether it can do so in float64.
struct EffectMethod {
    const char *id;
    bool knowsFloat64;
};
constexpr std::array effectMethods
    = {EffectMethod{"column-scan", false}, EffectMethod{"interpolate-bilinear", true},
       EffectMethod{"interpolate-plane", true}, EffectMethod{"interpolate-barycentric", true}};

class EffectReader {
public:
    EffectReader(JsonReader &json, CaseCoordinates &coordinates, HardCase &hardCase)
        : m_json(json)
        , m_coordinates(coordinates)
        , m_case(hardCase)
    {
    }

    void read(const JsonNode &node)
    {
        readAppearance(m_json, m_current, node);
        m_case.appearance = m_current.reading.scene.appearance;
        for (const JsonNode &triangle : m_json.array(member(node, "triangles"))) {
            if (m_json.hasFailed())
                break;
            readTriangle(triangle);
        }
        for (const SnapReport &snap : m_current.reading.snaps)
            m_case.displacements.append(snap.message());
    }

private:
    std::uint8_t level(const JsonNode &node) { return std::uint8_t(m_json.integer(node, 0, 255)); }

    void readTriangle(const JsonNode &node)
    {
        Triangle triangle;
        TriangleAttributes attributes = readAttributes(m_json, m_current, node);
        attributes.triangle = m_case.triangles.size();
        const std::vector<JsonNode> corners = m_json.array(member(node, "vertices"), 3);
        const JsonNode colours = member(node, "colours");
        const JsonNode alphas = member(node, "alpha");
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vertex &vertex = triangle.vertices[corner];
            vertex = {m_coordinates.position(corners[corner]), white};
            if (!alphas.isMissing())
                attributes.vertices[corner].alpha = level(alphas[qsizetype(corner)]);
            if (colours.isMissing())
                continue;
            const std::vector<JsonNode> channels = m_json.array(colours[qsizetype(corner)], 3);
            for (std::size_t channel = 0; channel < 3; ++channel)
                vertex.colour.channels[channel] = level(channels[channel]);
        }
        m_case.triangles.push_back(triangle);
        m_case.attributes.push_back(attributes);
    }

    JsonReader &m_json;
    CaseCoordinates &m_coordinates;
    HardCase &m_case;
    CurrentScene m_current{{}, ReferredFiles{{}}};
};

} // namespace

void readEffectCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                    HardCase &hardCase)
{
    EffectReader(json, coordinates, hardCase).read(node);
}

QStringList effectShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing)
{
    const Primitives primitives
        = {hardCase.triangles, {}, hardCase.attributes, hardCase.appearance};
    CasePicture picture(hardCase.canvas, settings.fillRule);
    picture.draw(primitives, settings, drawing);
    QStringList shortfalls;
    if (hardCase.displacements.isEmpty()) {
        comparePicture(shortfalls, hardCase.facts.at(settings.fillRule), picture);
        if (shortfalls.isEmpty())
            return shortfalls;
    }
    // Facts show that something is wrong; only the truth shows how many pixels.
    CasePicture truth(hardCase.canvas, settings.fillRule);
    truth.draw(primitives, settings, drawTruly);
    const DifferenceCounts differences = differencesBetween(picture, truth);
    if (differences.total() > 0)
        shortfalls.prepend(differences.message());
    return shortfalls;
}

QString effectRefusal(const ScanSettings &settings, const Method &method)
{
    QStringList able;
    for (const EffectMethod &each : effectMethods) {
        const QString id = QString::fromLatin1(each.id);
        able.append(id);
        if (method.id != id)
            continue;
        if (settings.arithmetic == Arithmetic::Exact || settings.arithmetic == Arithmetic::Float32
            || (settings.arithmetic == Arithmetic::Float64 && each.knowsFloat64))
            return {};
        return u"it draws effects in exact and float32 alone"_s;
    }
    return u"it draws no effects; these do: "_s + able.join(u", "_s);
}

} // namespace pixelplumb
