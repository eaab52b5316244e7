// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"
#include "core/scene/text/jsonreader.h"
#include "core/space/camera.h"

#include <limits>

namespace pixelplumb {

/// How many points a primitive may have.
struct PointCount {
    static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

    std::size_t least = 1;
    std::size_t most = 1;
};

/// Reads a scene's numbers: snaps them to their format and reports each displacement; errors stay
/// with the JsonReader.
class NumberReader {
public:
    NumberReader(JsonReader &json, SnapReports &snaps)
        : m_json(json)
        , m_snaps(snaps)
    {
    }

    Lattice coordinate(const JsonNode &node) { return number(node, coordinateFormat); }
    Attribute attribute(const JsonNode &node) { return number(node, attributeFormat); }
    template <std::size_t Count>
    std::array<Attribute, Count> attributes(const JsonNode &node);
    /// A number that is computed with in double, in the scene's space; at most
    /// largestAttributeValue.
    double real(const JsonNode &node);
    Vector3 vector(const JsonNode &node);
    /// A number above 0.
    double positive(const JsonNode &node, const QString &what);
    /// A coordinate above 0: a radius, a height.
    Lattice length(const JsonNode &node, const QString &what);
    LatticePoint position(const JsonNode &node);
    /// The positions before the first error.
    std::vector<LatticePoint> positions(const JsonNode &node, PointCount count);

private:
    std::int64_t number(const JsonNode &node, const NumberFormat &format);

    JsonReader &m_json;
    SnapReports &m_snaps;
};

template <std::size_t Count>
std::array<Attribute, Count> NumberReader::attributes(const JsonNode &node)
{
    const std::vector<JsonNode> numbers = m_json.array(node, Count);
    std::array<Attribute, Count> values = {};
    for (std::size_t i = 0; i < Count; ++i)
        values[i] = attribute(numbers[i]);
    return values;
}

} // namespace pixelplumb
