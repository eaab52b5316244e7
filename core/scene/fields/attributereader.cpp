// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/attributereader.h"

#include "core/scene/fields/primitivewriter.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

namespace {

const QString depthKey = "z";
const QString divisorKey = "w";
const QString textureKey = "uv";
const QString normalsKey = "normals";
const QString materialKey = "material";

using Vertices = std::array<VertexAttributes, 3>;

template <class Read>
void readEach(JsonReader &json, const JsonNode &node, Vertices &vertices, const Read &read)
{
    if (node.isMissing())
        return;
    const std::vector<JsonNode> values = json.array(node, qsizetype(vertices.size()));
    for (std::size_t i = 0; i < vertices.size() && !json.hasFailed(); ++i)
        read(values[i], vertices[i]);
}

/// A key with a value for each vertex; nothing where all have the default.
template <class Value>
QByteArray valuesText(const QString &key, const Vertices &vertices, Value VertexAttributes::*member)
{
    const Value byDefault = VertexAttributes().*member;
    if (std::ranges::all_of(vertices, [&](const auto &each) { return each.*member == byDefault; }))
        return {};
    QByteArray values;
    for (const VertexAttributes &vertex : vertices)
        values += (values.isEmpty() ? "" : ", ") + jsonAttributeText(vertex.*member);
    return ", \"" + key.toUtf8() + "\": [" + values + ']';
}

} // namespace

QStringList attributeKeys() { return {depthKey, divisorKey, textureKey, normalsKey, materialKey}; }

TriangleAttributes readAttributes(JsonReader &json, NumberReader &numbers, const JsonNode &triangle,
                                  const std::vector<Material> &materials)
{
    TriangleAttributes attributes;
    Vertices &vertices = attributes.vertices;
    readEach(json, triangle[depthKey], vertices,
             [&](const JsonNode &node, auto &vertex) { vertex.z = numbers.attribute(node); });
    readEach(json, triangle[divisorKey], vertices, [&](const JsonNode &node, auto &vertex) {
        vertex.w = numbers.attribute(node);
        if (vertex.w <= 0)
            json.fail(node, u"w of "_s + numberText(vertex.w, attributeFormat),
                      u"1/%1 or more"_s.arg(attributeOne));
    });
    readEach(json, triangle[textureKey], vertices, [&](const JsonNode &node, auto &vertex) {
        vertex.texture = numbers.attributes<2>(node);
    });
    readEach(json, triangle[normalsKey], vertices, [&](const JsonNode &node, auto &vertex) {
        vertex.normal = numbers.attributes<3>(node);
        if (vertex.normal == std::array<Attribute, 3>{})
            json.fail(node, "a normal of length 0",
                      u"a component of ±1/%1 or more"_s.arg(attributeOne));
    });
    attributes.material = readMaterialName(json, triangle[materialKey], materials);
    return attributes;
}

int readMaterialName(JsonReader &json, const JsonNode &node, const std::vector<Material> &materials)
{
    if (node.isMissing())
        return noMaterial;
    const std::string name = json.string(node).toStdString();
    const auto found = std::ranges::find(materials, name, &Material::name);
    if (found != materials.end())
        return int(found - materials.begin());
    QStringList names;
    for (const Material &material : materials)
        names.append(QString::fromStdString(material.name));
    json.fail(node, describe(node),
              names.isEmpty() ? u"one of the scene's \"materials\", which has none"_s
                              : u"one of "_s + names.join(u", "_s));
    return noMaterial;
}

QByteArray attributesText(const TriangleAttributes &attributes,
                          const std::vector<Material> &materials)
{
    const Vertices &vertices = attributes.vertices;
    return valuesText(depthKey, vertices, &VertexAttributes::z)
        + valuesText(divisorKey, vertices, &VertexAttributes::w)
        + valuesText(textureKey, vertices, &VertexAttributes::texture)
        + valuesText(normalsKey, vertices, &VertexAttributes::normal)
        + materialText(attributes.material, materials);
}

QByteArray materialText(int material, const std::vector<Material> &materials)
{
    if (material == noMaterial)
        return {};
    return ", \"" + materialKey.toUtf8()
        + "\": " + quotedText(QByteArray::fromStdString(materials[std::size_t(material)].name));
}

} // namespace pixelplumb
