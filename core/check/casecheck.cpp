// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"

#include "core/check/attributecase.h"
#include "core/check/casefacts.h"
#include "core/check/linecase.h"
#include "core/check/shapecase.h"

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
        const QString place = QStringLiteral("pixel (%1, %2)").arg(point.x).arg(point.y);
        const bool written = picture.isWritten(point.x, point.y);
        if (written != covered->second)
            shortfalls.append(
                place + (written ? QStringLiteral(" is drawn") : QStringLiteral(" is not drawn")));
        if (!written || !covered->second)
            continue;
        const Colour colour = picture.colourAt(point.x, point.y);
        const std::array<std::int64_t, 3> bytes = {colour.red(), colour.green(), colour.blue()};
        compare(shortfalls, place + QStringLiteral(" is"), numbersText(bytes),
                numbersText(point.roundedColour));
    }
}

/// How the picture departs from the case's facts.
QStringList factShortfalls(const HardCase &hardCase, FillRule rule, const CasePicture &picture)
{
    const ExpectedFacts &facts = hardCase.facts.at(rule);
    QStringList shortfalls;
    comparePicture(shortfalls, facts, picture);
    comparePoints(shortfalls, hardCase, rule, picture);
    return shortfalls;
}

QStringList triangleShortfalls(const HardCase &hardCase, const ScanSettings &settings,
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
    // Facts tell that something is wrong; only the truth tells how many pixels.
    const PictureDifference difference
        = differenceBetween(picture, pictureOf(triangle, hardCase.canvas, settings, drawTruly));
    if (!difference.isNone())
        shortfalls.prepend(difference.message());
    return shortfalls;
}

QStringList meshShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                           const Drawing &drawing)
{
    CoverageTimes times;
    for (const Triangle &triangle : hardCase.triangles)
        addCoverage(times, pictureOf(triangle, hardCase.canvas, settings, drawing));
    QStringList shortfalls;
    compareHistogram(shortfalls, histogramOf(times),
                     hardCase.facts.at(settings.fillRule).histogram);
    return shortfalls;
}

QStringList sequenceShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                               const Drawing &drawing)
{
    const ExpectedFacts &facts = hardCase.facts.at(settings.fillRule);
    using Pixels = std::set<std::array<std::int64_t, 2>>;
    std::vector<std::int64_t> counts;
    std::int64_t toggles = 0;
    Pixels before;
    for (const Triangle &triangle : hardCase.triangles) {
        Pixels pixels;
        pictureOf(triangle, hardCase.canvas, settings, drawing)
            .forEachWritten([&](std::int64_t x, std::int64_t y) {
                pixels.insert({x, y});
            });
        if (!counts.empty()) {
            std::vector<Pixels::value_type> toggled;
            std::ranges::set_symmetric_difference(before, pixels, std::back_inserter(toggled));
            toggles += std::int64_t(toggled.size());
        }
        counts.push_back(std::int64_t(pixels.size()));
        before = std::move(pixels);
    }
    QStringList shortfalls;
    compare(shortfalls, QStringLiteral("pixel counts"), numbersText(counts),
            numbersText(facts.frameCounts));
    compare(shortfalls, QStringLiteral("toggles"), toggles, facts.toggles);
    return shortfalls;
}

QStringList translationShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                                  const Drawing &drawing)
{
    const ExpectedFacts &facts = hardCase.facts.at(settings.fillRule);
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
        compare(shortfalls, QStringLiteral("moved by (%1, %2): pixel count").arg(right).arg(up),
                picture.pixelCount(), facts.pixelCount);
        std::vector<PlacedColour> pixels;
        picture.forEachWritten([&](std::int64_t x, std::int64_t y) {
            const Colour colour = picture.colourAt(x, y);
            pixels.push_back({x - canvas.firstColumn, y - canvas.firstRow, colour.red(),
                              colour.green(), colour.blue()});
        });
        pictures.insert(std::move(pixels));
    }
    compare(shortfalls, QStringLiteral("distinct pictures"), std::int64_t(pictures.size()),
            facts.distinctPictures);
    return shortfalls;
}

bool draws(const Method &method, const HardCase &hardCase)
{
    return hardCase.shapes.empty() ? method.draws(PrimitiveKind::Triangle)
                                   : method.draws(hardCase.shapes.front());
}

/// "a triangle", "an outlined circle": what a method has to draw.
QString subjectOf(const HardCase &hardCase)
{
    if (hardCase.shapes.empty())
        return QStringLiteral("a ") + nameOf(PrimitiveKind::Triangle);
    const Shape &shape = hardCase.shapes.front();
    if (shape.kind != PrimitiveKind::Circle)
        return QStringLiteral("a ") + nameOf(shape.kind);
    return (shape.fill == ShapeFill::Outline ? QStringLiteral("an outlined ")
                                             : QStringLiteral("a filled "))
        + nameOf(shape.kind);
}

/// Why the candidate refuses what the case draws; empty where it does not.
QString refusalOf(const Candidate &candidate, const HardCase &hardCase)
{
    return hardCase.kind == HardCaseKind::Polygon
        ? shapeRefusal(hardCase, candidate.settings, *candidate.method)
        : QString();
}

CandidateVerdict verdictOn(const Candidate &candidate, const HardCase &hardCase)
{
    CandidateVerdict verdict{candidate, CaseOutcome::Passed, {}};
    if (!hardCase.facts.contains(candidate.settings.fillRule)) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {QStringLiteral("the case has no facts under this rule")};
        return verdict;
    }
    const QString refusal = refusalOf(candidate, hardCase);
    if (!refusal.isEmpty()) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {refusal};
        return verdict;
    }
    verdict.remarks = shortfallsOf(hardCase, candidate.settings, candidate.method->draw);
    if (hardCase.kind == HardCaseKind::Attributes)
        verdict.remarks += valueShortfalls(hardCase, candidate.settings, *candidate.method);
    if (!verdict.remarks.isEmpty())
        verdict.outcome = CaseOutcome::FellShort;
    return verdict;
}

} // namespace

QString nameOf(CaseOutcome outcome)
{
    switch (outcome) {
    case CaseOutcome::Passed:
        return QStringLiteral("pass");
    case CaseOutcome::FellShort:
        return QStringLiteral("FAIL");
    case CaseOutcome::Skipped:
        return QStringLiteral("skip");
    }
    return {};
}

QString Candidate::name() const
{
    const auto text = [](std::string_view name) {
        return QString::fromUtf8(name.data(), qsizetype(name.size()));
    };
    return QStringList{method->id, text(nameOf(settings.arithmetic)),
                       text(nameOf(settings.fillRule))}
        .join(u' ');
}

std::int64_t CaseReport::count(CaseOutcome of) const
{
    return std::ranges::count(verdicts, of, &CandidateVerdict::outcome);
}

CaseOutcome CaseReport::summary() const
{
    if (outcome != CaseOutcome::Passed)
        return outcome;
    if (count(CaseOutcome::FellShort) > 0)
        return CaseOutcome::FellShort;
    const bool nothingDone = !verdicts.empty() && count(CaseOutcome::Passed) == 0;
    return nothingDone ? CaseOutcome::Skipped : CaseOutcome::Passed;
}

QStringList shortfallsOf(const HardCase &hardCase, const ScanSettings &settings,
                         const Drawing &drawing)
{
    switch (hardCase.kind) {
    case HardCaseKind::Triangle:
    case HardCaseKind::Attributes:
        return triangleShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Mesh:
        return meshShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Sequence:
        return sequenceShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Translation:
        return translationShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Line:
        return lineShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Circle:
    case HardCaseKind::Polygon:
        return shapeShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Invalid:
        break;
    }
    return {};
}

CaseReport checkCase(const HardCase &hardCase, const std::vector<Candidate> &candidates)
{
    CaseReport report;
    report.id = hardCase.id;
    if (hardCase.kind == HardCaseKind::Invalid) {
        if (hardCase.refusal.isEmpty()) {
            report.outcome = CaseOutcome::FellShort;
            report.remarks = {QStringLiteral("its coordinates are accepted")};
        } else {
            report.remarks = {QStringLiteral("refused: ") + hardCase.refusal};
        }
        return report;
    }
    if (!hardCase.displacements.isEmpty()) {
        report.remarks = {QStringLiteral("compared with the truth after snapping ")
                          + hardCase.displacements.join(QStringLiteral(", "))};
    }
    for (const Candidate &candidate : candidates) {
        if (draws(*candidate.method, hardCase))
            report.verdicts.push_back(verdictOn(candidate, hardCase));
    }
    if (report.verdicts.empty()) {
        report.outcome = CaseOutcome::Skipped;
        report.remarks.append(
            QStringLiteral("none of the methods draws %1").arg(subjectOf(hardCase)));
    }
    return report;
}

} // namespace pixelplumb
