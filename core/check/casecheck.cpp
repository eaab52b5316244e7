// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"

#include "core/check/attributecase.h"
#include "core/check/casepicture.h"
#include "core/check/effectcase.h"
#include "core/check/hardcase.h"
#include "core/check/linecase.h"
#include "core/check/shapecase.h"
#include "core/check/trianglecase.h"
#include "core/methods/method.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Side in pixels of the window around each examined place.
constexpr std::int32_t windowSide = 48;

/// The ends and the middle of a line or curve; a circle's or ellipse's highest, lowest, leftmost
/// and rightmost points.
std::vector<LatticePoint> placesOf(const Shape &shape)
{
    const LatticePoint &a = shape.vertices.front().position;
    const LatticePoint &b = shape.vertices.back().position;
    if (shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse)
        return {{b.x, a.y}, {2 * a.x - b.x, a.y}, {a.x, b.y}, {a.x, 2 * a.y - b.y}};
    return {a, b, {(a.x + b.x) / 2, (a.y + b.y) / 2}};
}

FrameSpec windowAround(const LatticePoint &place)
{
    FrameSpec window;
    window.width = windowSide;
    window.height = windowSide;
    window.firstColumn = std::int32_t(floorPixel(place.x) - windowSide / 2);
    window.firstRow = std::int32_t(floorPixel(place.y) - windowSide / 2);
    return window;
}

QString nameOfAntialiasing(Antialiasing antialiasing)
{
    switch (antialiasing) {
    case Antialiasing::Samples4:
        return u"4 samples"_s;
    case Antialiasing::Samples16:
        return u"16 samples"_s;
    case Antialiasing::None:
    case Antialiasing::Area:
        break;
    }
    return u"area"_s;
}

/// Whether the case's shapes are lines or curves that the method antialiases, one pixel wide: the
/// facts describe the thinnest pictures, so only the truth can tell what such a method should draw.
bool isStrokeCase(const HardCase &hardCase, const Method &method)
{
    return method.supports(Effect::Antialiasing) && !hardCase.shapes.empty()
        && std::ranges::all_of(hardCase.shapes, isStroke);
}

/// Where the shapes' antialiased pictures, by area and by 4 and 16 samples, differ from the truth,
/// around the shapes' ends, middles and extremes.
QStringList strokeShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing)
{
    QStringList shortfalls;
    for (const Shape &shape : hardCase.shapes) {
        for (const Antialiasing antialiasing :
             {Antialiasing::Area, Antialiasing::Samples4, Antialiasing::Samples16}) {
            Primitives primitives{{}, {shape}};
            primitives.appearance.antialiasing = antialiasing;
            for (const LatticePoint &place : placesOf(shape)) {
                CasePicture picture(windowAround(place), settings.fillRule);
                CasePicture truth(windowAround(place), settings.fillRule);
                picture.draw(primitives, settings, drawing);
                truth.draw(primitives, settings, drawTruly);
                const DifferenceCounts differences = differencesBetween(picture, truth);
                if (differences.total() > 0)
                    shortfalls += u"%1, near (%2, %3): %4"_s.arg(
                        nameOfAntialiasing(antialiasing), QString::number(floorPixel(place.x)),
                        QString::number(floorPixel(place.y)), differences.message());
            }
        }
    }
    return shortfalls;
}

bool draws(const Method &method, const HardCase &hardCase)
{
    return hardCase.shapes.empty() ? method.draws(PrimitiveKind::Triangle)
                                   : method.draws(hardCase.shapes.front());
}

/// "a triangle", "an outlined circle": what a method must be able to draw.
QString subjectOf(const HardCase &hardCase)
{
    if (hardCase.shapes.empty())
        return u"a "_s + nameOf(PrimitiveKind::Triangle);
    const Shape &shape = hardCase.shapes.front();
    if (shape.kind != PrimitiveKind::Circle)
        return u"a "_s + nameOf(shape.kind);
    return (shape.fill == ShapeFill::Outline ? u"an outlined "_s : u"a filled "_s)
        + nameOf(shape.kind);
}

/// Why none of the contenders draws the case: no method can, or those that can were not chosen.
QString whyNoneDraws(const HardCase &hardCase)
{
    QStringList able;
    for (const Method &method : methods()) {
        if (draws(method, hardCase))
            able.append(method.id);
    }
    const QString none = u"none of the methods checked draws "_s + subjectOf(hardCase);
    return able.isEmpty() ? none : none + u"; by name can be checked: "_s + able.join(u", "_s);
}

/// Why the contender refuses to draw the case; empty where it does not.
QString refusalOf(const Contender &contender, const HardCase &hardCase)
{
    if (hardCase.kind == HardCaseKind::Polygon)
        return shapeRefusal(hardCase, contender.settings, *contender.method);
    if (hardCase.kind == HardCaseKind::Effects)
        return effectRefusal(contender.settings, *contender.method);
    return {};
}

/// Shortfalls of the method's plain kernel, and of its fast ones where theirs differ.
QStringList paintingShortfalls(const HardCase &hardCase, const Contender &contender)
{
    const Method &method = *contender.method;
    const Drawing drawn = drawingBy(method, Kernels::Plain);
    if (isStrokeCase(hardCase, method))
        return strokeShortfalls(hardCase, contender.settings, drawn);
    QStringList shortfalls = shortfallsOf(hardCase, contender.settings, drawn);
    if (!method.hasFastKernels)
        return shortfalls;
    const QStringList byFast
        = shortfallsOf(hardCase, contender.settings, drawingBy(method, Kernels::Fastest));
    if (byFast != shortfalls) {
        for (const QString &shortfall : byFast)
            shortfalls += u"fast kernels: "_s + shortfall;
    }
    return shortfalls;
}

ContenderVerdict verdictOn(const Contender &contender, const HardCase &hardCase)
{
    ContenderVerdict verdict{contender, CaseOutcome::Passed, {}};
    if (!hardCase.facts.contains(contender.settings.fillRule)) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {"the case has no facts under this rule"};
        return verdict;
    }
    const QString refusal = refusalOf(contender, hardCase);
    if (!refusal.isEmpty()) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {refusal};
        return verdict;
    }
    verdict.remarks = paintingShortfalls(hardCase, contender);
    if (hardCase.kind == HardCaseKind::Attributes)
        verdict.remarks += valueShortfalls(hardCase, contender.settings, *contender.method);
    if (!verdict.remarks.isEmpty())
        verdict.outcome = CaseOutcome::FellShort;
    return verdict;
}

} // namespace

QString nameOf(CaseOutcome outcome)
{
    switch (outcome) {
    case CaseOutcome::Passed:
        return u"pass"_s;
    case CaseOutcome::FellShort:
        return u"FAIL"_s;
    case CaseOutcome::Skipped:
        return u"skip"_s;
    }
    return {};
}

std::int64_t CaseReport::count(CaseOutcome of) const
{
    return std::ranges::count(verdicts, of, &ContenderVerdict::outcome);
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
    case HardCaseKind::Mesh:
    case HardCaseKind::Sequence:
    case HardCaseKind::Translation:
        return triangleShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Line:
        return lineShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Circle:
    case HardCaseKind::Polygon:
        return shapeShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Effects:
        return effectShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Invalid:
        break;
    }
    return {};
}

CaseReport checkCase(const HardCase &hardCase, const std::vector<Contender> &contenders)
{
    CaseReport report;
    report.id = hardCase.id;
    if (hardCase.kind == HardCaseKind::Invalid) {
        if (hardCase.refusal.isEmpty()) {
            report.outcome = CaseOutcome::FellShort;
            report.remarks = {"its coordinates are accepted"};
        } else {
            report.remarks = {u"refused: "_s + hardCase.refusal};
        }
        return report;
    }
    if (!hardCase.displacements.isEmpty()) {
        report.remarks
            = {u"compared with the truth after snapping "_s + hardCase.displacements.join(u", "_s)};
    }
    for (const Contender &contender : contenders) {
        if (draws(*contender.method, hardCase))
            report.verdicts.push_back(verdictOn(contender, hardCase));
    }
    if (report.verdicts.empty()) {
        report.outcome = CaseOutcome::Skipped;
        report.remarks.append(whyNoneDraws(hardCase));
    }
    return report;
}

} // namespace pixelplumb
