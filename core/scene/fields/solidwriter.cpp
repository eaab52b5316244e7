// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/solidwriter.h"

#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "core/scene/fields/attributereader.h"
#include "core/scene/fields/primitivewriter.h"
#include "core/scene/fields/referredfiles.h"
#include "core/scene/text/colourtext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QByteArray member(const char *key, const QByteArray &value)
{
    return QByteArray(", \"") + key + "\": " + value;
}

QByteArray blendedColourText(const Colour &colour, std::uint8_t alpha)
{
    return '"' + colourText(BlendedColour{colour, alpha}).toUtf8() + '"';
}

template <class Text>
QByteArray cornersText(std::span<const SolidCorner> corners, const Text &text)
{
    QByteArray list = "[";
    for (const SolidCorner &corner : corners)
        list += (list.size() > 1 ? ", " : "") + text(corner);
    return list + ']';
}

QByteArray positionsText(std::span<const SolidCorner> corners)
{
    return cornersText(corners,
                       [](const SolidCorner &corner) { return jsonRealsText(corner.position); });
}

/// What each corner of a triangle3 or polygon3 carries.
QByteArray cornerValuesText(const std::vector<SolidCorner> &corners)
{
    const auto isSame = [&corners](const auto &value) {
        return std::ranges::all_of(
            corners, [&](const SolidCorner &each) { return value(each) == value(corners[0]); });
    };
    const auto colour
        = [](const SolidCorner &corner) { return blendedColourText(corner.colour, corner.alpha); };
    QByteArray text = isSame(colour) ? member("color", colour(corners[0]))
                                     : member("colors", cornersText(corners, colour));
    const auto hasAny = [&corners](auto SolidCorner::*value) {
        return std::ranges::any_of(corners, [value](const SolidCorner &corner) {
            return corner.*value != SolidCorner().*value;
        });
    };
    if (hasAny(&SolidCorner::texture))
        text += member("uv", cornersText(corners, [](const SolidCorner &corner) {
                           return jsonRealsText(corner.texture);
                       }));
    if (hasAny(&SolidCorner::normal))
        text += member("normals", cornersText(corners, [](const SolidCorner &corner) {
                           return jsonRealsText(corner.normal);
                       }));
    return text;
}

QByteArray patchText(const Solid &solid)
{
    QByteArray rows = "[";
    for (std::size_t row = 0; row < 4; ++row)
        rows += (row > 0 ? ", " : "") + positionsText(std::span(solid.corners).subspan(4 * row, 4));
    return rows + ']';
}

QByteArray segmentsText(const Solid &solid)
{
    return member("segments",
                  '[' + QByteArray::number(solid.segments[0]) + ", "
                      + QByteArray::number(solid.segments[1]) + ']');
}

/// What follows the key that names the solid, without its material.
QByteArray valueText(const Solid &solid, const QString &folder)
{
    const QByteArray colour = member("color", blendedColourText(solid.colour, solid.alpha));
    switch (solid.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
        return positionsText(solid.corners) + cornerValuesText(solid.corners);
    case SolidKind::Plane:
        break;
    case SolidKind::Sphere:
        return jsonRealsText(solid.corners.front().position)
            + member("radius", jsonRealText(solid.radius)) + segmentsText(solid) + colour;
    case SolidKind::Patch:
        return patchText(solid) + segmentsText(solid) + colour;
    case SolidKind::Mesh:
        return quotedText(nameInFolder(solid.mesh->name, folder).toUtf8())
            + member("at", jsonRealsText(solid.at)) + member("scale", jsonRealText(solid.scale))
            + member("rotate", jsonRealsText(solid.rotate)) + colour;
    }
    return positionsText(solid.corners) + colour;
}

} // namespace

QByteArray primitiveText(const Solid &solid, const std::vector<Material> &materials,
                         const QString &folder)
{
    return "{ \"" + nameText(nameOf(solid.kind)).toUtf8() + "\": " + valueText(solid, folder)
        + materialText(solid.material, materials)
        + (solid.isHidden ? QByteArray(", \"hidden\": true") : QByteArray()) + " }";
}

} // namespace pixelplumb
