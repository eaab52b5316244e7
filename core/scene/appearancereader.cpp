// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/appearancereader.h"

#include "core/scene/appearancenames.h"
#include "core/scene/choicereader.h"
#include "core/scene/colourreader.h"

#include <algorithm>

namespace pixelplumb {

namespace {

void readOptionalColour(JsonReader &json, const JsonNode &node, Colour &colour)
{
    if (!node.isMissing())
        colour = readColour(json, node);
}

Material readMaterial(JsonReader &json, ReferredFiles &files, const JsonNode &node)
{
    const QString textureKey = QStringLiteral("texture");
    json.expectObject(node,
                      {textureKey, QStringLiteral("filter"), QStringLiteral("wrap"),
                       QStringLiteral("diffuse"), QStringLiteral("specular"),
                       QStringLiteral("shininess")});
    Material material;
    if (const JsonNode texture = node[textureKey]; !texture.isMissing()) {
        const QString name = json.string(texture);
        if (json.hasFailed())
            return material;
        if (const auto read = files.texture(name))
            material.texture = *read;
        else
            json.fail(texture, QStringLiteral("%1: %2").arg(read.error().place, read.error().found),
                      read.error().expected);
    }
    readChoice(json, node["filter"], allTextureFilters, material.filter);
    readChoice(json, node["wrap"], allTextureWraps, material.wrap);
    readOptionalColour(json, node["diffuse"], material.diffuse);
    readOptionalColour(json, node["specular"], material.specular);
    if (const JsonNode shininess = node["shininess"]; !shininess.isMissing())
        material.shininess = int(json.integer(shininess, 1, mostShininess));
    return material;
}

std::vector<Material> readMaterials(JsonReader &json, ReferredFiles &files, const JsonNode &node)
{
    std::vector<Material> materials;
    if (node.isMissing())
        return materials;
    if (!node.isObject())
        json.fail(node, describe(node), QStringLiteral("an object with a material for each name"));
    const QStringList names = node.keys();
    for (const QString &name : names) {
        if (json.hasFailed())
            break;
        Material material = readMaterial(json, files, node[name]);
        material.name = name.toStdString();
        if (std::ranges::find(materials, material.name, &Material::name) != materials.end())
            json.fail(node[name], QStringLiteral("a second material of this name in UTF-8"),
                      QStringLiteral("every name once"));
        materials.push_back(std::move(material));
    }
    return materials;
}

Light readLight(JsonReader &json, NumberReader &numbers, const JsonNode &node)
{
    const QString directionKey = QStringLiteral("direction");
    const QString positionKey = QStringLiteral("position");
    const QString colourKey = QStringLiteral("color");
    json.expectObject(node, {directionKey, positionKey, colourKey});
    const JsonNode direction = node[directionKey];
    const JsonNode position = node[positionKey];
    Light light;
    if (direction.isMissing() == position.isMissing())
        json.fail(node,
                  direction.isMissing() ? QStringLiteral("a light without direction and position")
                                        : QStringLiteral("both direction and position"),
                  QStringLiteral("one of the two"));
    light.kind = direction.isMissing() ? Light::Kind::Positional : Light::Kind::Directional;
    const JsonNode &at = direction.isMissing() ? position : direction;
    light.at = numbers.attributes<3>(at);
    if (light.kind == Light::Kind::Directional && light.at == std::array<Attribute, 3>{})
        json.fail(at, QStringLiteral("a direction of length 0"),
                  QStringLiteral("a component of ±1/%1 or more").arg(attributeOne));
    readOptionalColour(json, node[colourKey], light.colour);
    return light;
}

std::vector<Light> readLights(JsonReader &json, NumberReader &numbers, const JsonNode &node)
{
    std::vector<Light> lights;
    if (node.isMissing())
        return lights;
    const std::vector<JsonNode> nodes = json.array(node);
    if (nodes.size() > mostLights)
        json.fail(node, QStringLiteral("%1 lights").arg(nodes.size()),
                  QStringLiteral("at most %1").arg(mostLights));
    for (const JsonNode &each : nodes) {
        if (json.hasFailed())
            break;
        lights.push_back(readLight(json, numbers, each));
    }
    return lights;
}

} // namespace

QStringList appearanceKeys()
{
    return {QStringLiteral("materials"),   QStringLiteral("lights"), QStringLiteral("ambient"),
            QStringLiteral("shading"),     QStringLiteral("depth"),  QStringLiteral("depthBits"),
            QStringLiteral("antialiasing")};
}

Appearance readAppearance(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                          const JsonNode &root)
{
    Appearance appearance;
    appearance.materials = readMaterials(json, files, root["materials"]);
    appearance.lights = readLights(json, numbers, root["lights"]);
    readOptionalColour(json, root["ambient"], appearance.ambient);
    readChoice(json, root["shading"], allShadings, appearance.shading);
    readChoice(json, root["depth"], allDepthUses, appearance.depth);
    readChoice(json, root["depthBits"], allDepthFormats, appearance.depthFormat);
    readChoice(json, root["antialiasing"], allAntialiasings, appearance.antialiasing);
    return appearance;
}

} // namespace pixelplumb
