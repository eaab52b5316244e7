// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/framereader.h"

#include "core/frame/framenames.h"
#include "core/scene/text/choicereader.h"
#include "core/scene/text/colourreader.h"

namespace pixelplumb {

FrameSpec readFrame(JsonReader &json, const JsonNode &node)
{
    json.expectObject(node,
                      {"width", "height", "background", "origin", "pixelCentre", "firstPixel"});
    FrameSpec frame;
    const JsonNode width = node["width"];
    frame.width = std::int32_t(json.integer(width, 1, largestFrameSide));
    frame.height = std::int32_t(json.integer(node["height"], 1, largestFrameSide));
    const qint64 area = qint64(frame.width) * frame.height;
    if (area > largestFrameArea) {
        json.fail(
            width,
            QStringLiteral("%1 × %2 are %3 pixels").arg(frame.width).arg(frame.height).arg(area),
            QStringLiteral("at most %1 pixels").arg(largestFrameArea));
    }
    if (const JsonNode background = node["background"]; !background.isMissing())
        frame.background = readColour(json, background);
    readChoice(json, node["origin"], allFrameOrigins, frame.origin);
    readChoice(json, node["pixelCentre"], allPixelCentres, frame.pixelCentre);
    if (const JsonNode first = node["firstPixel"]; !first.isMissing()) {
        const std::vector<JsonNode> pixel = json.array(first, 2);
        frame.firstColumn = std::int32_t(json.integer(pixel[0], -largestPixel, largestPixel));
        frame.firstRow = std::int32_t(json.integer(pixel[1], -largestPixel, largestPixel));
    }
    return frame;
}

} // namespace pixelplumb
