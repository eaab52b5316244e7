// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/partreader.h"

#include "core/scene/fields/listreader.h"
#include "core/scene/text/choicereader.h"
#include "core/space/spacevector.h"

#include <cmath>

namespace pixelplumb {

namespace {

/// Directions count as parallel when the sine of their angle is smaller.
constexpr double smallestSine = 1e-9;

class SurroundingsReader : public ListReader<SurroundingsReader> {
public:
    SurroundingsReader(JsonReader &json, CurrentScene &current)
        : ListReader(json, current)
    {
    }

    using ListReader::read;
    void read(const JsonNode &node, const NumberBetween<double> &field)
    {
        field.number = m_numbers.real(node);
        if (!(field.number > field.above && field.number < field.below))
            m_json.fail(node, describe(node),
                        std::isinf(field.below)
                            ? u"more than %1"_s.arg(field.above)
                            : u"more than %1 and less than %2"_s.arg(field.above).arg(field.below));
    }
    template <class Choice, class Choices>
    void read(const JsonNode &node, const ChoiceOf<Choice, Choices> &field)
    {
        readChoice(m_json, node, field.all, field.choice);
    }
    void read(const JsonNode &node, const FirstPixelOf<FrameSpec> &field)
    {
        const std::vector<JsonNode> pixel = m_json.array(node, 2);
        read(pixel[0], NumberWithin{field.frame.firstColumn, -largestPixel, largestPixel});
        read(pixel[1], NumberWithin{field.frame.firstRow, -largestPixel, largestPixel});
    }
    void read(const JsonNode &node, VariantSet &variants)
    {
        for (const JsonNode &each : m_json.array(node)) {
            Variant variant = allVariants.front();
            readChoice(m_json, each, allVariants, variant);
            variants = variants.with(variant);
        }
    }
    void read(const JsonNode &node, FrameSpec &frame)
    {
        readObject(node, frame);
        if (const qint64 area = qint64(frame.width) * frame.height; area > largestFrameArea)
            m_json.fail(node["width"],
                        u"%1 × %2 are %3 pixels"_s.arg(frame.width).arg(frame.height).arg(area),
                        u"at most %1 pixels"_s.arg(largestFrameArea));
    }
    void read(const JsonNode &node, Motion &motion) { readObject(node, motion); }

    void read(const JsonNode &node, Camera &camera)
    {
        m_json.expectObject(
            node, {"projection", "eye", "target", "up", "fieldOfView", "height", "near", "far"});
        readFields(node, camera);
        const bool isPerspective = camera.projection == Projection::Perspective;
        const auto own = QLatin1String(isPerspective ? "fieldOfView" : "height");
        const auto others = QLatin1String(isPerspective ? "height" : "fieldOfView");
        if (const JsonNode foreign = node[others]; !foreign.isMissing())
            m_json.fail(
                foreign,
                u"“%1” of a camera that is %2"_s.arg(others, nameText(nameOf(camera.projection))),
                u"“%1”"_s.arg(own));
        const JsonNode far = node["far"];
        if (camera.far <= camera.near)
            m_json.fail(far.isMissing() ? node : far,
                        u"near %1 and far %2"_s.arg(camera.near).arg(camera.far),
                        "a far plane behind the near one");
        checkDirections(node, camera);
    }
    void checkDirections(const JsonNode &node, const Camera &camera)
    {
        using Vector = SpaceVector<double>;
        const Vector sight = Vector(camera.target) - Vector(camera.eye);
        const Vector upwards(camera.up);
        const JsonNode up = node["up"];
        if (sight.isZero())
            m_json.fail(node, "eye and target are one point",
                        "two points, between which the camera looks");
        if (upwards.isZero())
            m_json.fail(up, "a direction of length 0", "the direction that is up");
        if (lengthOf(cross(sight, upwards)) <= smallestSine * lengthOf(sight) * lengthOf(upwards))
            m_json.fail(up.isMissing() ? node : up, "up is parallel to the view from eye to target",
                        "a direction across it");
    }

    void read(const JsonNode &node, std::vector<Material> &materials)
    {
        if (!node.isObject())
            m_json.fail(node, describe(node), "an object with a material for each name");
        for (const QString &name : node.keys()) {
            readObject(node[name], materials.emplace_back());
            materials.back().name = name.toStdString();
        }
    }

    void read(const JsonNode &node, std::vector<Light> &lights)
    {
        const std::vector<JsonNode> nodes = m_json.array(node);
        if (nodes.size() > mostLights)
            m_json.fail(node, u"%1 lights"_s.arg(nodes.size()), u"at most %1"_s.arg(mostLights));
        for (const JsonNode &each : nodes) {
            if (m_json.hasFailed())
                break;
            read(each, lights.emplace_back());
        }
    }
    void read(const JsonNode &node, Light &light)
    {
        m_json.expectObject(node, {"direction", "position", "color"});
        const bool isPositional = node["direction"].isMissing();
        if (isPositional == node["position"].isMissing())
            m_json.fail(node,
                        isPositional ? u"a light without direction and position"_s
                                     : u"both direction and position"_s,
                        "one of the two");
        light.kind = isPositional ? Light::Kind::Positional : Light::Kind::Directional;
        readFields(node, light);
        if (!isPositional && light.at == std::array<Attribute, 3>{})
            m_json.fail(node["direction"], "a direction of length 0",
                        u"a component of ±1/%1 or more"_s.arg(attributeOne));
    }
};

} // namespace

void readAppearance(JsonReader &json, CurrentScene &current, const JsonNode &root)
{
    SurroundingsReader(json, current).readFields(root, current.reading.scene.appearance);
}

QStringList surroundingKeys() { return fieldNames<Scene>() + fieldNames<Appearance>(); }

void readSurroundings(JsonReader &json, CurrentScene &current)
{
    SurroundingsReader(json, current).readFields(json.root(), current.reading.scene);
    readAppearance(json, current, json.root());
}

} // namespace pixelplumb
