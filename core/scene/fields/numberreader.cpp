// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/numberreader.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

constexpr qint64 beyondAllFormats = std::numeric_limits<qint64>::max();

qint64 wholeNumber(QByteArrayView digits)
{
    qint64 number = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
    return end == digits.end() && error == std::errc() ? number : beyondAllFormats;
}

QString writtenIn(const JsonNode &node)
{
    if (node.isString())
        return node.toString();
    const QByteArrayView digits = node.written();
    return digits.size() > longestNumberText ? numberText(digits.toDouble())
                                             : QString::fromLatin1(digits);
}

} // namespace

std::int64_t NumberReader::number(const JsonNode &node, const NumberFormat &format)
{
    if (!node.isNumber() && !node.isString()) {
        m_json.fail(node, describe(node), expectationOf(format));
        return 0;
    }
    // Most are whole numbers, and a scene may hold millions: these need no big numbers.
    if (const qint64 whole = wholeNumber(node.written());
        whole >= -format.largest && whole <= format.largest)
        return whole * format.one;
    const QString written = writtenIn(node);
    const Result<SnappedNumber> snapped = parseNumber(written, format);
    if (!snapped) {
        m_json.fail(node, snapped.error().found, snapped.error().expected);
        return 0;
    }
    if (snapped->isDisplaced())
        m_snaps.add({m_snaps.keepsNext() ? node.path() : QString(), written, *snapped, &format});
    return snapped->units;
}

double NumberReader::real(const JsonNode &node)
{
    if (const double number = node.toDouble(std::numeric_limits<double>::infinity());
        std::abs(number) <= largestAttributeValue)
        return number;
    if (!node.isNumber() && !node.isString()) {
        m_json.fail(node, describe(node), expectationOf(attributeFormat));
        return 0;
    }
    const Result<double> value = parseReal(writtenIn(node), attributeFormat);
    if (!value)
        m_json.fail(node, value.error().found, value.error().expected);
    return value ? *value : 0;
}

LatticePoint NumberReader::position(const JsonNode &node)
{
    const std::vector<JsonNode> coordinates = m_json.array(node, 2);
    const Lattice x = coordinate(coordinates[0]);
    return {x, coordinate(coordinates[1])};
}

} // namespace pixelplumb
