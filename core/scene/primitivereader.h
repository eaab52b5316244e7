// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/colourtext.h"
#include "core/scene/numberreader.h"

namespace pixelplumb {

/// The keys that name a primitive, in the order in which messages list them.
QStringList primitiveKeys();

/// A colour "#rrggbb"; an error stays with the JsonReader.
Colour readColour(JsonReader &json, const JsonNode &node);
/// A colour "#rrggbb" or "#rrggbbaa".
BlendedColour readBlendedColour(JsonReader &json, const JsonNode &node);

/// Reads the primitives of a scene; errors stay with the JsonReader.
class PrimitiveReader {
public:
    PrimitiveReader(JsonReader &json, SceneReading &reading)
        : m_json(json)
        , m_reading(reading)
        , m_numbers(json, reading.snaps)
    {
    }

    /// Appends the primitive to the scene's triangles or shapes.
    void read(const JsonNode &primitive);

private:
    PrimitiveKind kindOf(const JsonNode &primitive);
    void readTriangle(const JsonNode &primitive);
    void readPoints(const JsonNode &primitive, Shape &shape);
    void readLine(const JsonNode &primitive, Shape &shape);
    void readRound(const JsonNode &primitive, Shape &shape);
    void readBezier(const JsonNode &primitive, Shape &shape);
    void readPolygon(const JsonNode &primitive, Shape &shape);
    void readText(const JsonNode &primitive, Shape &shape);

    void appendPositions(const JsonNode &node, PointCount count, Shape &shape);
    void readColours(const JsonNode &primitive, Shape &shape);
    void readColourOfAll(const JsonNode &primitive, Shape &shape);
    ShapeFill fill(const JsonNode &node, PrimitiveKind kind);

    JsonReader &m_json;
    SceneReading &m_reading;
    NumberReader m_numbers;
};

} // namespace pixelplumb
