// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/attributereader.h"

#include "core/scene/coordinatetext.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

namespace {

const QString depthKey = QStringLiteral("z");
const QString textureKey = QStringLiteral("uv");
const QString normalsKey = QStringLiteral("normals");

constexpr Attribute perLatticeUnit = attributeOne / unitsPerPixel;

QByteArray numberText(Attribute units)
{
    const QByteArray text = coordinateText(units / perLatticeUnit).toUtf8();
    return text.contains('/') ? '"' + text + '"' : text;
}

QByteArray arrayText(std::span<const Attribute> numbers)
{
    QByteArray text = "[";
    for (const Attribute number : numbers)
        text += (text.size() > 1 ? ", " : "") + numberText(number);
    return text + ']';
}

/// A key with an array for each vertex; nothing where all numbers are 0.
template <std::size_t Count>
QByteArray arraysText(const QString &key, const std::array<VertexAttributes, 3> &vertices,
                      std::array<Attribute, Count> VertexAttributes::*member)
{
    const bool isEmpty = std::ranges::all_of(vertices, [member](const VertexAttributes &vertex) {
        return vertex.*member == std::array<Attribute, Count>{};
    });
    if (isEmpty)
        return {};
    QByteArray text;
    for (const VertexAttributes &vertex : vertices)
        text += (text.isEmpty() ? "" : ", ") + arrayText(vertex.*member);
    return ", \"" + key.toUtf8() + "\": [" + text + ']';
}

} // namespace

QStringList attributeKeys() { return {depthKey, textureKey, normalsKey}; }

std::optional<std::array<VertexAttributes, 3>> readAttributes(
    JsonReader &json, const JsonNode &triangle,
    const std::function<Lattice(const JsonNode &)> &number)
{
    const JsonNode depth = triangle[depthKey];
    const JsonNode texture = triangle[textureKey];
    const JsonNode normals = triangle[normalsKey];
    if (depth.isMissing() && texture.isMissing() && normals.isMissing())
        return std::nullopt;
    std::array<VertexAttributes, 3> vertices;
    if (!depth.isMissing()) {
        const std::vector<JsonNode> numbers = json.array(depth, 3);
        for (std::size_t i = 0; i < 3; ++i)
            vertices[i].z = number(numbers[i]) * perLatticeUnit;
    }
    const auto readArrays = [&](const JsonNode &node, auto member) {
        if (node.isMissing())
            return;
        const std::vector<JsonNode> arrays = json.array(node, 3);
        for (std::size_t i = 0; i < 3; ++i) {
            auto &target = vertices[i].*member;
            const std::vector<JsonNode> numbers = json.array(arrays[i], qsizetype(target.size()));
            for (std::size_t k = 0; k < target.size(); ++k)
                target[k] = number(numbers[k]) * perLatticeUnit;
        }
    };
    readArrays(texture, &VertexAttributes::texture);
    readArrays(normals, &VertexAttributes::normal);
    return vertices;
}

QByteArray attributesText(const std::array<VertexAttributes, 3> &vertices)
{
    const std::array<Attribute, 3> depths = {vertices[0].z, vertices[1].z, vertices[2].z};
    QByteArray text;
    if (depths != std::array<Attribute, 3>{})
        text += ", \"" + depthKey.toUtf8() + "\": " + arrayText(depths);
    return text + arraysText(textureKey, vertices, &VertexAttributes::texture)
        + arraysText(normalsKey, vertices, &VertexAttributes::normal);
}

} // namespace pixelplumb
