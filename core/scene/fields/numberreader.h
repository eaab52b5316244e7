// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"
#include "core/scene/text/jsonreader.h"

namespace pixelplumb {

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
    /// A number that is computed with in double, in the scene's space; at most
    /// largestAttributeValue.
    double real(const JsonNode &node);
    LatticePoint position(const JsonNode &node);

private:
    std::int64_t number(const JsonNode &node, const NumberFormat &format);

    JsonReader &m_json;
    SnapReports &m_snaps;
};

} // namespace pixelplumb
