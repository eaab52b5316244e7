// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/choicenames.h"
#include "core/scene/fields/listreader.h"
#include "core/scene/fields/partreader.h"
#include "core/scene/fields/primitivefields.h"
#include "core/scene/solidfault.h"

namespace pixelplumb {

namespace {

constexpr std::array allKinds = {
    PrimitiveKind::Triangle, PrimitiveKind::Point,  PrimitiveKind::Line,    PrimitiveKind::Circle,
    PrimitiveKind::Ellipse,  PrimitiveKind::Bezier, PrimitiveKind::Polygon, PrimitiveKind::Text};

const QString hiddenKey = "hidden";

class PrimitiveReader : public ListReader<PrimitiveReader> {
public:
    PrimitiveReader(JsonReader &json, CurrentScene &current)
        : ListReader(json, current)
        , m_scene(current.reading.scene)
    {
    }

    void readPrimitive(const JsonNode &primitive)
    {
        QStringList keys;
        for (const SolidKind kind : allSolidKinds) {
            const JsonNode node = primitive[nameOf(kind).data()];
            if (!node.isMissing())
                return readSolid(primitive, node, kind);
        }
        for (const PrimitiveKind kind : allKinds) {
            const JsonNode node = primitive[keyOf(kind)];
            if (!node.isMissing())
                return kind == PrimitiveKind::Triangle ? readTriangle(primitive, node)
                                                       : readShape(primitive, node, kind);
            keys.append(keyOf(kind));
        }
        keys += namesOf(allSolidKinds);
        // Reports a misspelt key before the missing primitive.
        m_json.expectObject(primitive, keys + QStringList{"color", "colors", "fill", hiddenKey});
        m_json.fail(primitive, "no primitive is named", u"one of "_s + keys.join(u", "_s));
    }

    void check(const JsonNode &triangle, const TriangleAttributes &attributes)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            if (const Attribute w = attributes.vertices[i].w; w <= 0)
                m_json.fail(triangle["w"][qsizetype(i)],
                            u"w of "_s + numberText(w, attributeFormat),
                            u"1/%1 or more"_s.arg(attributeOne));
        }
        checkNormals(triangle, attributes.vertices, &VertexAttributes::normal,
                     u"a component of ±1/%1 or more"_s.arg(attributeOne));
    }

    using ListReader::read;
    void read(const JsonNode &node, const PointsOf<Shape> &field)
    {
        if (!field.partsKey || !node.isObject())
            return appendPoints(node, field);
        const QString key = field.partsKey;
        m_json.expectObject(node, {key});
        const std::vector<JsonNode> parts = m_json.array(node[key]);
        if (parts.empty())
            m_json.fail(node[key], field.noParts, "one or more arrays of points");
        for (const JsonNode &part : parts) {
            if (m_json.hasFailed())
                return;
            if (!field.shape.vertices.empty())
                field.shape.laterContours.push_back(field.shape.vertices.size());
            appendPoints(part, field);
        }
    }
    void read(const JsonNode &node, const RoundOf<Shape> &field)
    {
        RoundFields round = {field.shape.kind};
        readObject(node, round);
        auto &[kind, centre, radii] = round;
        if (kind == PrimitiveKind::Circle)
            radii.y = radii.x;
        const LatticePoint corner = {centre.x + radii.x, centre.y + radii.y};
        if (!isWithinRange(corner) || !isWithinRange({centre.x - radii.x, centre.y - radii.y}))
            m_json.fail(node, u"the %1 leaves ±%2 px"_s.arg(keyOf(kind)).arg(largestPixel),
                        "a smaller radius or another centre");
        field.shape.vertices = {{centre, {}}, {corner, {}}};
    }
    void read(const JsonNode &node, const FillOf<Shape> &field)
    {
        QStringList names;
        for (const FillName &each : fillNamesOf(field.shape.kind)) {
            names.append(QLatin1String(each.name));
            if (node.toString() == names.back()) {
                field.shape.fill = each.fill;
                return;
            }
        }
        m_json.fail(node, describe(node), u"one of "_s + names.join(u", "_s));
    }
    void read(const JsonNode &node, const MaterialOf<int> &field)
    {
        const std::string name = m_json.string(node).toStdString();
        const std::vector<Material> &materials = m_scene.appearance.materials;
        QStringList names;
        for (const Material &material : materials) {
            names.append(QString::fromStdString(material.name));
            if (material.name == name) {
                field.index = int(names.size()) - 1;
                return;
            }
        }
        m_json.fail(node, describe(node),
                    names.isEmpty() ? u"one of the scene's \"materials\", which has none"_s
                                    : u"one of "_s + names.join(u", "_s));
    }

private:
    bool isHidden(const JsonNode &primitive)
    {
        const JsonNode hidden = primitive[hiddenKey];
        return !hidden.isMissing() && m_json.boolean(hidden);
    }
    bool hasShapes() const
    {
        return !m_scene.shapes.empty()
            || (!m_scene.hidden.empty() && !m_scene.hidden.back().isTriangle());
    }

    void readTriangle(const JsonNode &primitive, const JsonNode &node)
    {
        // Made once: a scene may have millions.
        static const QStringList keys = fieldNames(HiddenTriangle()) + QStringList{hiddenKey};
        HiddenTriangle read;
        m_json.expectObject(primitive, keys);
        readFields(primitive, read);
        check(primitive, read.attributes);
        if (hasShapes() || !m_scene.solids.empty())
            m_json.fail(node, "a triangle after another primitive",
                        "all triangles first: they are drawn before the others");
        if (isHidden(primitive)) {
            m_scene.hidden.push_back({m_scene.triangles.size(), read});
            return;
        }
        if (read.attributes != TriangleAttributes()) {
            read.attributes.triangle = m_scene.triangles.size();
            m_scene.attributes.push_back(read.attributes);
        }
        m_scene.triangles.push_back(read.triangle);
    }

    void readShape(const JsonNode &primitive, const JsonNode &node, PrimitiveKind kind)
    {
        Shape shape;
        shape.kind = kind;
        if (const auto fills = fillNamesOf(kind); !fills.empty())
            shape.fill = fills.front().fill;
        if (kind == PrimitiveKind::Text) {
            countVertices(node, node.toString().size() * qsizetype(verticesOfCharacter));
            shape.vertices.resize(1);
            // Fonts are drawn for this rule: the outlines of a letter may overlap.
            shape.fill = ShapeFill::NonZero;
        }
        readObject(primitive, shape, {hiddenKey});
        if (kind == PrimitiveKind::Bezier && node.isObject() && shape.fill == ShapeFill::Outline)
            m_json.fail(node, "a path that is not filled",
                        "\"fill\": \"even-odd\" or \"non-zero\"; without it, one curve of three or "
                        "four points");
        if (isHidden(primitive))
            m_scene.hidden.push_back({m_scene.shapes.size(), std::move(shape)});
        else
            m_scene.shapes.push_back(std::move(shape));
    }

    void readSolid(const JsonNode &primitive, const JsonNode &node, SolidKind kind)
    {
        const QString key = nameText(nameOf(kind));
        if (hasShapes())
            m_json.fail(node, u"a %1 after a shape of the frame"_s.arg(key),
                        "triangles, then what is seen through the camera, then shapes");
        if (!m_scene.camera)
            m_json.fail(node, u"a %1 in a scene without a camera"_s.arg(key),
                        "a key \"camera\" of the scene: { \"eye\": [0, 0, 5], … }");
        Solid solid = emptySolid(node, kind);
        readObject(primitive, solid, {hiddenKey});
        solid.isHidden = isHidden(primitive);
        if (!primitive["color"].isMissing() && !primitive["colors"].isMissing())
            m_json.fail(primitive["colors"], "both color and colors", "one of the two");
        checkNormals(primitive, solid.corners, &SolidCorner::normal, u"a direction"_s);
        if (m_json.hasFailed())
            return;
        if (const auto fault = faultOf(solid))
            m_json.fail(node, fault->found, fault->expected);
        m_current.solidTriangles += triangleCount(solid);
        if (m_current.solidTriangles > mostSolidTriangles)
            m_json.fail(node, tooManyTriangles(m_current.solidTriangles), fewerTriangles());
        m_scene.solids.push_back(std::move(solid));
    }
    Solid emptySolid(const JsonNode &node, SolidKind kind)
    {
        Solid solid;
        solid.kind = kind;
        switch (kind) {
        case SolidKind::Triangle3:
        case SolidKind::Plane:
            solid.corners.resize(3);
            break;
        case SolidKind::Polygon3:
            solid.corners.resize(m_json.array(node).size());
            if (solid.corners.size() < 3)
                m_json.fail(node, describe(node), "an array of 3 points or more");
            break;
        case SolidKind::Sphere:
            solid.corners.resize(1);
            break;
        case SolidKind::Patch:
            solid.corners.resize(16);
            solid.segments = {8, 8};
            break;
        case SolidKind::Mesh:
            break;
        }
        return solid;
    }

    template <class Vertices, class Vertex, class Normal>
    void checkNormals(const JsonNode &primitive, const Vertices &vertices, Normal Vertex::*normal,
                      const QString &expected)
    {
        const JsonNode nodes = primitive["normals"];
        for (qsizetype i = 0; i < nodes.size() && !m_json.hasFailed(); ++i) {
            if (vertices[std::size_t(i)].*normal == Normal())
                m_json.fail(nodes[i], "a normal of length 0", expected);
        }
    }

    /// Adds `more` vertices or characters to the count of the scene's shapes; an error above the
    /// limit.
    void countVertices(const JsonNode &node, qsizetype more)
    {
        m_current.shapeVertices += std::size_t(more);
        if (m_current.shapeVertices > mostShapeVertices)
            m_json.fail(node, tooManyVertices(m_current.shapeVertices), fewerVertices());
    }
    void appendPoints(const JsonNode &node, const PointsOf<Shape> &field)
    {
        countVertices(node, node.size());
        if (m_json.hasFailed())
            return;
        const auto [least, most] = field.count;
        const std::vector<JsonNode> points = m_json.array(node);
        if (points.size() < least || points.size() > most) {
            const QString range = most == PointCount::any
                ? u"%1 points or more"_s.arg(least)
                : u"%1 points"_s.arg(least) + (most > least ? u" or %1"_s.arg(most) : QString());
            m_json.fail(node, describe(node), u"an array of "_s + range);
        }
        for (std::size_t i = 0; i < points.size() && !m_json.hasFailed(); ++i)
            field.shape.vertices.push_back({m_numbers.position(points[i]), {}});
    }

    Scene &m_scene;
};

} // namespace

TriangleAttributes readAttributes(JsonReader &json, CurrentScene &current, const JsonNode &triangle)
{
    TriangleAttributes attributes;
    PrimitiveReader reader(json, current);
    reader.readFields(triangle, attributes);
    reader.check(triangle, attributes);
    return attributes;
}

void readPrimitive(JsonReader &json, CurrentScene &current, const JsonNode &primitive)
{
    PrimitiveReader(json, current).readPrimitive(primitive);
}

} // namespace pixelplumb
