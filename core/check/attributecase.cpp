// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/attributecase.h"

#include "core/frame/writtenframe.h"
#include "core/methods/shading/shadednumbers.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// "85/42" or "-3"; fails unless both parts are integers of 64 bits, the second above 0.
Quantity fraction(JsonReader &json, const JsonNode &node)
{
    const QStringList parts = json.string(node).split(u'/');
    bool isNumerator = false;
    bool isDenominator = false;
    const qint64 numerator = parts.front().toLongLong(&isNumerator);
    const qint64 denominator = parts.value(1, "1").toLongLong(&isDenominator);
    if (isNumerator && isDenominator && denominator > 0 && parts.size() <= 2)
        return Quantity::rational(numerator, denominator);
    json.fail(node, describe(node), "a fraction such as “85/42”");
    return {};
}

bool isChannel(const QString &title)
{
    const ShadedScope all = interpolationScope(InterpolationForm::Bilinear, {true, true, true});
    return std::ranges::any_of(all.channels, [&](const ScopedChannel &channel) {
        return shadedName(channel.which) == title;
    });
}

/// A sample's value in a channel: 0 in a channel that no triangle carries.
Quantity valueOf(const ScanTrace &trace, const SampleRecord &sample, const QString &title)
{
    const auto &columns = trace.numbers().sample;
    const auto found = std::ranges::find(columns, title, &NumberDescription::title);
    return found == columns.end() ? Quantity::integer(0)
                                  : sample.cells[std::size_t(found - columns.begin())];
}

/// The record of the sample at a point; none where the trace did not visit it.
std::optional<SampleRecord> sampleAt(const ScanTrace &trace, const ExpectedPoint &point)
{
    const std::optional<std::size_t> visit = trace.visitOf(0, point.x, point.y);
    if (!visit)
        return std::nullopt;
    const std::size_t span = trace.spanOf(*visit);
    return trace.samples(span)[*visit - trace.firstSampleOf(span)];
}

void compareValues(QStringList &shortfalls, const ExpectedPoint &point, const SampleRecord &sample,
                   const ScanTrace &trace)
{
    for (const auto &[title, expected] : point.values) {
        const Quantity value = valueOf(trace, sample, title);
        if (value == expected)
            continue;
        shortfalls.append(u"pixel (%1, %2): %3 is %4 instead of %5"_s.arg(point.x).arg(point.y).arg(
            title, toText(value), toText(expected)));
    }
}

} // namespace

void readAttributes(JsonReader &json, const JsonNode &node, HardCase &hardCase)
{
    constexpr std::int64_t largest = largestAttributeValue * unitsPerPixel; // units of 1/256, as in
                                                                            // the file
    const auto value = [&json](const JsonNode &each) {
        return Attribute(json.integer(each, -largest, largest)) * (attributeOne / unitsPerPixel);
    };
    TriangleAttributes attributes;
    const std::vector<JsonNode> corners = json.array(member(node, "attributes"), 3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        VertexAttributes &vertex = attributes.vertices[corner];
        vertex.z = value(member(corners[corner], "z"));
        const std::vector<JsonNode> texture = json.array(member(corners[corner], "uv"), 2);
        std::ranges::transform(texture, vertex.texture.begin(), value);
        const std::vector<JsonNode> normal = json.array(member(corners[corner], "normal"), 3);
        std::ranges::transform(normal, vertex.normal.begin(), value);
    }
    hardCase.attributes = {attributes};
}

std::map<QString, Quantity> readExpectedValues(JsonReader &json, const JsonNode &node)
{
    std::map<QString, Quantity> values;
    const QStringList titles = node.keys();
    for (const QString &title : titles) {
        if (isChannel(title))
            values[title] = fraction(json, node[title]);
        else
            json.fail(node[title], u"“%1”"_s.arg(title),
                      "a title of what is interpolated: R, G, B, z, u, v, N_x, N_y, N_z");
    }
    return values;
}

QStringList valueShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                            const Method &method)
{
    const bool pointsUp = settings.fillRule != FillRule::TopLeft;
    const bool hasValues = method.family == MethodFamily::Interpolation;
    if (settings.arithmetic != Arithmetic::Exact || !pointsUp || !hasValues
        || !hardCase.displacements.isEmpty())
        return {};
    const WrittenFrame frame(hardCase.canvas);
    const Run run(&method, {hardCase.triangles, {}, hardCase.attributes}, settings, frame.view());
    const std::unique_ptr<ScanTrace> trace = run.trace(frame.view());
    QStringList shortfalls;
    for (const ExpectedPoint &point : hardCase.points) {
        const auto covered = point.covered.find(settings.fillRule);
        if (covered == point.covered.end() || !covered->second)
            continue;
        if (const std::optional<SampleRecord> sample = sampleAt(*trace, point))
            compareValues(shortfalls, point, *sample, *trace);
        else
            shortfalls.append(u"pixel (%1, %2) has no values"_s.arg(point.x).arg(point.y));
    }
    return shortfalls;
}

} // namespace pixelplumb
