// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/linecase.h"

#include "core/check/casecoordinates.h"

#include <QCryptographicHash>

#include <algorithm>

namespace pixelplumb {

namespace {

/// The only rule in the format.
const char *const nearestRule = "major axis, floor(minor + 1/2)";

/// Pixels around the line's end points, to show drawings that err.
constexpr std::int64_t margin = 16;
/// Rows (columns for a steep line) drawn at a time, so that a long line needs no large frame. The
/// line's whole length is always in the frame: drift must have room to show.
constexpr std::int64_t bandBreadth = 256;

CasePixel pixelOf(const Vertex &vertex)
{
    return {floorPixel(vertex.position.x), floorPixel(vertex.position.y)};
}

/// The axis along which a line case lists its pixels: x unless the line is longer along y.
std::size_t listedAxis(const Shape &line)
{
    const LatticePoint a = line.vertices[0].position;
    const LatticePoint b = line.vertices[1].position;
    return absolute(b.y - a.y) > absolute(b.x - a.x) ? 1 : 0;
}

/// The pixels that a drawing writes of a line, in the order of the facts.
std::vector<CasePixel> pixelsOf(const Shape &line, const FrameSpec &canvas,
                                const ScanSettings &settings, const Drawing &drawing)
{
    const std::size_t along = listedAxis(line);
    const std::int64_t breadth = along == 0 ? canvas.height : canvas.width;
    std::vector<CasePixel> pixels;
    for (std::int64_t done = 0; done < breadth; done += bandBreadth) {
        FrameSpec band = canvas;
        (along == 0 ? band.height : band.width)
            = std::int32_t(std::min(bandBreadth, breadth - done));
        (along == 0 ? band.firstRow : band.firstColumn) += std::int32_t(done);
        CasePicture picture(band, FillRule::Closed);
        picture.draw(Primitives{{}, {line}}, settings, drawing);
        picture.forEachWritten([&](std::int64_t x, std::int64_t y) { pixels.push_back({x, y}); });
    }
    std::ranges::sort(pixels, [along](const CasePixel &a, const CasePixel &b) {
        return std::pair(a[along], a[1 - along]) < std::pair(b[along], b[1 - along]);
    });
    return pixels;
}

QByteArray hashOf(const std::vector<CasePixel> &pixels)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const CasePixel &pixel : pixels)
        hash.addData(QByteArray::number(qint64(pixel[0])) + ' '
                     + QByteArray::number(qint64(pixel[1])) + '\n');
    return hash.result().toHex().first(16);
}

/// How many of the pixels are not among the others.
std::int64_t countOutside(std::vector<CasePixel> pixels, std::vector<CasePixel> others)
{
    std::ranges::sort(pixels);
    std::ranges::sort(others);
    std::vector<CasePixel> outside;
    std::ranges::set_difference(pixels, others, std::back_inserter(outside));
    return std::int64_t(outside.size());
}

/// How the pixels drawn in one direction differ from the facts.
QStringList shortfalls(const std::vector<CasePixel> &drawn, const std::vector<CasePixel> &truth,
                       const ExpectedFacts &facts)
{
    QStringList remarks;
    if (const auto count = std::int64_t(drawn.size()); count != facts.pixelCount.value_or(count))
        remarks.append(u"pixel count %1 instead of %2"_s.arg(count).arg(*facts.pixelCount));
    if (!facts.pixelHash.isEmpty() && hashOf(drawn) != facts.pixelHash)
        remarks.append(u"pixel hash %1 instead of %2"_s.arg(QString::fromLatin1(hashOf(drawn)),
                                                            QString::fromLatin1(facts.pixelHash)));
    if (!facts.pixels.empty() && drawn != facts.pixels)
        remarks.append(u"other pixels than the case lists"_s);
    if (remarks.isEmpty())
        return remarks;
    DifferenceCounts differences;
    differences.add(Difference::Missing, countOutside(truth, drawn));
    differences.add(Difference::Extra, countOutside(drawn, truth));
    if (differences.total() > 0)
        remarks.prepend(differences.message());
    return remarks;
}

} // namespace

void readLineCase(JsonReader &json, const JsonNode &node, HardCase &hardCase)
{
    const JsonNode rule = member(node, "rule");
    if (rule.toString() != QLatin1String(nearestRule))
        json.fail(rule, describe(rule), u"“%1”"_s.arg(QLatin1String(nearestRule)));
    const std::vector<JsonNode> ends = json.array(member(node, "endpoints"), 2);
    CaseCoordinates coordinates(json, hardCase);
    coordinates.readOptionalScale(node);
    Shape line;
    line.kind = PrimitiveKind::Line;
    line.vertices = {{coordinates.position(ends[0]), {{255, 0, 0}}},
                     {coordinates.position(ends[1]), {{0, 0, 255}}}};
    if (!hardCase.displacements.isEmpty())
        json.fail(member(node, "endpoints"), "ends off the lattice",
                  u"multiples of 1/%1 px"_s.arg(unitsPerPixel));
    hardCase.shapes = {line};
    const CasePixel a = pixelOf(line.vertices[0]);
    const CasePixel b = pixelOf(line.vertices[1]);

    const CasePixel size
        = {absolute(b[0] - a[0]) + 1 + 2 * margin, absolute(b[1] - a[1]) + 1 + 2 * margin};
    const CasePixel first = {std::min(a[0], b[0]) - margin, std::min(a[1], b[1]) - margin};
    if (std::max(size[0], size[1]) > largestFrameSide || size[0] * size[1] > largestFrameArea)
        json.fail(member(node, "endpoints"), "a line that no frame holds",
                  u"at most %1 px on a side and %2 px in area"_s.arg(largestFrameSide - 2 * margin)
                      .arg(largestFrameArea));
    if (json.hasFailed())
        return;
    hardCase.canvas.width = std::int32_t(size[0]);
    hardCase.canvas.height = std::int32_t(size[1]);
    hardCase.canvas.firstColumn = std::int32_t(first[0]);
    hardCase.canvas.firstRow = std::int32_t(first[1]);

    const JsonNode expected = member(node, "expected");
    ExpectedFacts &facts = hardCase.facts[FillRule::Closed];
    if (const JsonNode count = member(expected, "count"); !count.isMissing())
        facts.pixelCount = json.integer(count, 0, largestFrameArea);
    if (const JsonNode hash = member(expected, "sha"); !hash.isMissing())
        facts.pixelHash = json.string(hash).toLatin1();
    if (const JsonNode pixels = member(expected, "pixels"); !pixels.isMissing()) {
        for (const JsonNode &each : json.array(pixels))
            facts.pixels.push_back(pixel(json, each));
    }
}

QStringList lineShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                           const Drawing &drawing)
{
    const ExpectedFacts &facts = hardCase.facts.at(FillRule::Closed);
    const Shape &line = hardCase.shapes.front();
    Shape reversed = line;
    std::swap(reversed.vertices[0], reversed.vertices[1]);
    const std::vector<CasePixel> truth = pixelsOf(line, hardCase.canvas, settings, drawTruly);
    QStringList remarks
        = shortfalls(pixelsOf(line, hardCase.canvas, settings, drawing), truth, facts);
    const QStringList ofReversed
        = shortfalls(pixelsOf(reversed, hardCase.canvas, settings, drawing), truth, facts);
    for (const QString &remark : ofReversed)
        remarks.append(u"reversed: "_s + remark);
    return remarks;
}

} // namespace pixelplumb
