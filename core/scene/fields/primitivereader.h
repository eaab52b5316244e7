// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/scene/fields/referredfiles.h"

namespace pixelplumb {

/// The keys that name a primitive, in the order in which messages list them.
QStringList primitiveKeys();

/// A scene while it is read.
struct CurrentScene {
    SceneReading reading;
    ReferredFiles files;
    std::size_t solidTriangles = 0; ///< that its solids are cut into so far
    /// Of its shapes so far; each character of a text counts as several.
    std::size_t shapeVertices = 0;
};

/// Reads the primitives of a scene; errors stay with the JsonReader.
class PrimitiveReader {
public:
    PrimitiveReader(JsonReader &json, CurrentScene &current)
        : m_json(json)
        , m_current(current)
        , m_scene(current.reading.scene)
        , m_numbers(json, current.reading.snaps)
    {
    }

    /// Appends the primitive to the scene's triangles, solids, shapes or hidden ones.
    void read(const JsonNode &primitive);

private:
    PrimitiveKind kindOf(const JsonNode &primitive);
    /// Fails on keys other than these and those that every primitive of the frame may have.
    void expectKeys(const JsonNode &primitive, const QStringList &keys);
    bool isHidden(const JsonNode &primitive);
    bool hasShapes() const
    {
        return !m_scene.shapes.empty()
            || (!m_scene.hidden.empty() && !m_scene.hidden.back().isTriangle());
    }
    void readSolid(const JsonNode &primitive, SolidKind kind);
    void readTriangle(const JsonNode &primitive);
    void readPoints(const JsonNode &primitive, PointCount count, Shape &shape);
    void readRound(const JsonNode &primitive, Shape &shape);
    void readBezier(const JsonNode &primitive, Shape &shape);
    void readPolygon(const JsonNode &primitive, Shape &shape);
    void readContours(const JsonNode &primitive, const QString &partsKey, const QString &none,
                      PointCount count, Shape &shape);
    void readText(const JsonNode &primitive, Shape &shape);

    /// Adds `more` vertices or characters to the count of the scene's shapes; an error above the
    /// limit.
    void countVertices(const JsonNode &node, qsizetype more);
    void appendPositions(const JsonNode &node, PointCount count, Shape &shape);
    /// Reads the arrays of points of a shape with several parts; `none` is the error where there
    /// are none.
    void appendParts(const JsonNode &node, const QString &none, PointCount count, Shape &shape);
    void readColours(const JsonNode &primitive, Shape &shape);
    void readColourOfAll(const JsonNode &primitive, Shape &shape);
    ShapeFill fill(const JsonNode &node, PrimitiveKind kind);

    JsonReader &m_json;
    CurrentScene &m_current;
    Scene &m_scene;
    NumberReader m_numbers;
};

} // namespace pixelplumb
