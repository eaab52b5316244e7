// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/colourreader.h"

namespace pixelplumb {

BlendedColour readBlendedColour(JsonReader &json, const JsonNode &node)
{
    const Result<BlendedColour> result = parseColour(json.string(node));
    if (result)
        return *result;
    json.fail(node, result.error().found, result.error().expected);
    return {};
}

Colour readColour(JsonReader &json, const JsonNode &node)
{
    const BlendedColour colour = readBlendedColour(json, node);
    if (colour.alpha != 255)
        json.fail(node,
                  u"“%1” is not opaque, and only triangles are blended"_s.arg(node.toString()),
                  "alpha ff, or #rrggbb without alpha");
    return colour.colour;
}

} // namespace pixelplumb
