// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecoordinates.h"

#include "core/scene/text/coordinatetext.h"

#include <limits>

namespace pixelplumb {

namespace {

/// The digits of an integer, which may need more than 64 bits.
QString wholeText(const JsonNode &node)
{
    constexpr qint64 none = std::numeric_limits<qint64>::min();
    const qint64 integer = node.toInteger(none);
    return integer == none ? QString::fromLatin1(node.written()) : QString::number(integer);
}

} // namespace

JsonNode member(const JsonNode &node, const char *key) { return node[key]; }

CasePixel pixel(JsonReader &json, const JsonNode &node)
{
    const std::vector<JsonNode> coordinates = json.array(node, 2);
    CasePixel pixel = {};
    for (std::size_t axis = 0; axis < 2; ++axis)
        pixel[axis] = json.integer(coordinates[axis], -largestPixel, largestPixel);
    return pixel;
}

void CaseCoordinates::readScale(const JsonNode &node)
{
    const JsonNode scale = member(node, "scale");
    m_scale = wholeText(scale);
    if (scale.toDouble(0) < 1)
        m_json.fail(scale, describe(scale), "the units in a pixel, 1 or more");
}

void CaseCoordinates::readOptionalScale(const JsonNode &node)
{
    if (!member(node, "scale").isMissing())
        readScale(node);
}

void CaseCoordinates::readCanvas(const JsonNode &node)
{
    FrameSpec &canvas = m_case.canvas;
    const std::vector<JsonNode> size = m_json.array(member(node, "canvas"), 2);
    canvas.width = std::int32_t(m_json.integer(size[0], 1, largestFrameSide));
    canvas.height = std::int32_t(m_json.integer(
        size[1], 1, qMin<qint64>(largestFrameSide, largestFrameArea / canvas.width)));
    const CasePixel origin = pixel(m_json, member(node, "origin"));
    canvas.firstColumn = std::int32_t(origin[0]);
    canvas.firstRow = std::int32_t(origin[1]);
}

Lattice CaseCoordinates::coordinate(const JsonNode &node)
{
    const QString written = u"%1/%2"_s.arg(wholeText(node), m_scale);
    const Result<SnappedNumber> snapped = parseCoordinate(written);
    if (!node.isNumber() || !snapped) {
        m_json.fail(node, describe(node),
                    u"an integer in units of 1/scale px, within ±%1 px"_s.arg(largestPixel));
        return 0;
    }
    if (snapped->isDisplaced()) {
        const QString path = node.path();
        m_case.displacements.append(u"%1 by %2 px"_s.arg(path.mid(path.lastIndexOf(u'.') + 1),
                                                         toText(snapped->displacement)));
    }
    return snapped->units;
}

LatticePoint CaseCoordinates::position(const JsonNode &node)
{
    const std::vector<JsonNode> coordinates = m_json.array(node, 2);
    return {coordinate(coordinates[0]), coordinate(coordinates[1])};
}

} // namespace pixelplumb
