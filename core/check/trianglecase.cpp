// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/trianglecase.h"

#include "core/check/casefacts.h"

#include <algorithm>
#include <set>

namespace pixelplumb {

namespace {

CasePicture pictureOf(const Triangle &triangle, const FrameSpec &canvas,
                      const ScanSettings &settings, const Drawing &drawing)
{
    CasePicture picture(canvas, settings.fillRule);
    picture.draw(triangle, settings, drawing);
    return picture;
}

void comparePoints(QStringList &shortfalls, const HardCase &hardCase, FillRule rule,
                   const CasePicture &picture)
{
    for (const ExpectedPoint &point : hardCase.points) {
        const auto covered = point.covered.find(rule);
        if (covered == point.covered.end() || !picture.contains(point.x, point.y))
            continue;
        const QString place = u"pixel (%1, %2)"_s.arg(point.x).arg(point.y);
        const bool written = picture.isWritten(point.x, point.y);
        if (written != covered->second)
            shortfalls.append(place + (written ? u" is drawn"_s : u" is not drawn"_s));
        if (!written || !covered->second)
            continue;
        const Colour colour = picture.colourAt(point.x, point.y);
        const std::array<std::int64_t, 3> bytes = {colour.red(), colour.green(), colour.blue()};
        compare(shortfalls, place + u" is"_s, numbersText(bytes), numbersText(point.roundedColour));
    }
}

/// How the picture differs from the case's facts.
QStringList factShortfalls(const HardCase &hardCase, FillRule rule, const CasePicture &picture)
{
    const ExpectedFacts &facts = hardCase.facts.at(rule);
    QStringList shortfalls;
    comparePicture(shortfalls, facts, picture);
    comparePoints(shortfalls, hardCase, rule, picture);
    return shortfalls;
}

QStringList singleShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing)
{
    const Triangle &triangle = hardCase.triangles.front();
    const CasePicture picture = pictureOf(triangle, hardCase.canvas, settings, drawing);
    QStringList shortfalls;
    if (hardCase.displacements.isEmpty()) {
        shortfalls = factShortfalls(hardCase, settings.fillRule, picture);
        if (shortfalls.isEmpty())
            return shortfalls;
    }
    // Facts show that something is wrong; only the truth shows how many pixels.
    const DifferenceCounts differences
        = differencesBetween(picture, pictureOf(triangle, hardCase.canvas, settings, drawTruly));
    if (differences.total() > 0)
        shortfalls.prepend(differences.message());
    return shortfalls;
}

/// How many pixels the triangles cover once, twice, … when each is drawn alone.
std::map<int, std::int64_t> meshHistogram(const HardCase &hardCase, const ScanSettings &settings,
                                          const Drawing &drawing)
{
    CoverageTimes times;
    for (const Triangle &triangle : hardCase.triangles)
        addCoverage(times, pictureOf(triangle, hardCase.canvas, settings, drawing));
    return histogramOf(times);
}

/// What the frames of a sequence draw.
struct SequenceTally {
    std::vector<std::int64_t> counts; ///< pixels of each frame
    std::int64_t toggles = 0; ///< pixels that change between frames
};

SequenceTally tallyOfSequence(const HardCase &hardCase, const ScanSettings &settings,
                              const Drawing &drawing)
{
    using Pixels = std::set<std::array<std::int64_t, 2>>;
    SequenceTally tally;
    Pixels before;
    for (const Triangle &triangle : hardCase.triangles) {
        Pixels pixels;
        pictureOf(triangle, hardCase.canvas, settings, drawing)
            .forEachWritten([&](std::int64_t x, std::int64_t y) {
                pixels.insert({x, y});
            });
        if (!tally.counts.empty()) {
            std::vector<Pixels::value_type> toggled;
            std::ranges::set_symmetric_difference(before, pixels, std::back_inserter(toggled));
            tally.toggles += std::int64_t(toggled.size());
        }
        tally.counts.push_back(std::int64_t(pixels.size()));
        before = std::move(pixels);
    }
    return tally;
}

/// The expected results for the drawn vertices: the case's facts or, where these hold for vertices
/// off the lattice, what the truth draws.
ExpectedFacts factsOf(const HardCase &hardCase, const ScanSettings &settings)
{
    if (hardCase.displacements.isEmpty())
        return hardCase.facts.at(settings.fillRule);
    ExpectedFacts facts;
    if (hardCase.kind == HardCaseKind::Mesh)
        facts.histogram = meshHistogram(hardCase, settings, drawTruly);
    if (hardCase.kind == HardCaseKind::Sequence) {
        const SequenceTally tally = tallyOfSequence(hardCase, settings, drawTruly);
        facts.frameCounts = tally.counts;
        facts.toggles = tally.toggles;
    }
    if (hardCase.kind == HardCaseKind::Translation) {
        // A move by whole pixels only moves the truth.
        facts.pixelCount
            = pictureOf(hardCase.triangles.front(), hardCase.canvas, settings, drawTruly)
                  .pixelCount();
        facts.distinctPictures = 1;
    }
    return facts;
}

QStringList meshShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                           const Drawing &drawing)
{
    QStringList shortfalls;
    compareHistogram(shortfalls, meshHistogram(hardCase, settings, drawing),
                     factsOf(hardCase, settings).histogram);
    return shortfalls;
}

QStringList sequenceShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                               const Drawing &drawing)
{
    const ExpectedFacts facts = factsOf(hardCase, settings);
    const SequenceTally tally = tallyOfSequence(hardCase, settings, drawing);
    QStringList shortfalls;
    compare(shortfalls, "pixel counts", numbersText(tally.counts), numbersText(facts.frameCounts));
    compare(shortfalls, "toggles", tally.toggles, facts.toggles);
    return shortfalls;
}

QStringList translationShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                                  const Drawing &drawing)
{
    const ExpectedFacts facts = factsOf(hardCase, settings);
    QStringList shortfalls;
    using PlacedColour = std::array<std::int64_t, 5>; // x, y from the canvas' corner, R, G, B
    std::set<std::vector<PlacedColour>> pictures;
    for (const auto &[right, up] : hardCase.offsets) {
        FrameSpec canvas = hardCase.canvas;
        canvas.firstColumn += std::int32_t(right);
        canvas.firstRow += std::int32_t(up);
        Triangle triangle = hardCase.triangles.front();
        for (Vertex &vertex : triangle.vertices) {
            vertex.position.x += right * unitsPerPixel;
            vertex.position.y += up * unitsPerPixel;
        }
        const CasePicture picture = pictureOf(triangle, canvas, settings, drawing);
        compare(shortfalls, u"moved by (%1, %2): pixel count"_s.arg(right).arg(up),
                picture.pixelCount(), facts.pixelCount);
        std::vector<PlacedColour> pixels;
        picture.forEachWritten([&](std::int64_t x, std::int64_t y) {
            const Colour colour = picture.colourAt(x, y);
            pixels.push_back({x - canvas.firstColumn, y - canvas.firstRow, colour.red(),
                              colour.green(), colour.blue()});
        });
        pictures.insert(std::move(pixels));
    }
    compare(shortfalls, "distinct pictures", std::int64_t(pictures.size()), facts.distinctPictures);
    return shortfalls;
}

} // namespace

QStringList triangleShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                               const Drawing &drawing)
{
    if (hardCase.kind == HardCaseKind::Mesh)
        return meshShortfalls(hardCase, settings, drawing);
    if (hardCase.kind == HardCaseKind::Sequence)
        return sequenceShortfalls(hardCase, settings, drawing);
    if (hardCase.kind == HardCaseKind::Translation)
        return translationShortfalls(hardCase, settings, drawing);
    return singleShortfalls(hardCase, settings, drawing);
}

} // namespace pixelplumb
