// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/colourtext.h"
#include "core/scene/numberreader.h"
#include "core/scene/referredfiles.h"

namespace pixelplumb {

/// The keys that name a primitive, in the order in which messages list them.
QStringList primitiveKeys();

/// A colour "#rrggbb"; an error stays with the JsonReader.
Colour readColour(JsonReader &json, const JsonNode &node);
/// A colour "#rrggbb" or "#rrggbbaa".
BlendedColour readBlendedColour(JsonReader &json, const JsonNode &node);

/// A scene while it is read.
struct SceneInHand {
    SceneReading reading;
    ReferredFiles files;
    std::size_t solidTriangles = 0; ///< into which its solids are cut so far
};

/// Reads the primitives of a scene; errors stay with the JsonReader.
class PrimitiveReader {
public:
    PrimitiveReader(JsonReader &json, SceneInHand &inHand)
        : m_json(json)
        , m_inHand(inHand)
        , m_scene(inHand.reading.scene)
        , m_numbers(json, inHand.reading.snaps)
    {
    }

    /// Appends the primitive to the scene's triangles, solids or shapes.
    void read(const JsonNode &primitive);

private:
    PrimitiveKind kindOf(const JsonNode &primitive);
    void readSolid(const JsonNode &primitive, SolidKind kind);
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
    SceneInHand &m_inHand;
    Scene &m_scene;
    NumberReader m_numbers;
};

} // namespace pixelplumb
