// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/linedefect.h"

#include "core/grade/rounding/linechoice.h"
#include "core/methods/method.h"

namespace pixelplumb {

namespace {

/// Whether a program that draws this scene can have the mistake under that name.
bool canHave(const LineBugs &bugs, const Scene &scene, const Method &method)
{
    const bool isBresenham = method.supports(Variant::StayAtZero);
    if (bugs.stepsItself())
        return isBresenham;
    if (bugs.missing == MissingEnd::Greatest) // otherwise that variant leaves out the same pixel
        return !method.supports(Variant::OneStepShort);
    if (bugs.rounding == AcrossRounding::HalvesDown)
        return !isBresenham && drawsNearestPixels(scene);
    return bugs.steepPixels == SteepPixels::OneARow || method.id != u"line-slope-intercept"_s;
}

Defect defectBy(const LineRow &row)
{
    Defect defect = drawnLinesBy(row.bugs,
                                 {QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
                                  QString::fromUtf8(row.forAssistant)});
    // Both pixels are equally near.
    defect.isRightAlone = row.bugs.rounding == AcrossRounding::HalvesDown;
    return defect;
}

Defect defectFrom(LineStart start, LineRow row)
{
    const bool fromLeft = start == LineStart::LeastAlong;
    row.bugs.start = start;
    Defect defect = defectBy(row);
    if (fromLeft)
        defect.id.prepend(u"sorted-"_s);
    defect.forAssistant += fromLeft
        ? u"; steps begin at the end with the lesser x, of steep lines y."_s
        : u"; steps begin at a line's first end."_s;
    return defect;
}

} // namespace

std::vector<Defect> lineDefectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    if (!isOfLines(scene))
        return defects;
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    const bool stepsBetweenSamples = method.supports(Variant::StayAtZero);
    for (const auto &rows : {lineDecisionRows(), lineStepRows()}) {
        for (const LineRow &row : rows) {
            for (const LineStart start : {LineStart::FirstEnd, LineStart::LeastAlong}) {
                if (stepsBetweenSamples)
                    defects.push_back(defectFrom(start, row));
            }
        }
    }
    for (const auto &rows : {lineEndRows(), linePixelRows()}) {
        for (const LineRow &row : rows) {
            if (!canHave(row.bugs, scene, method))
                continue;
            defects.push_back(defectBy(row));
            // Combined with a scene's defect of such lines it would act on all lines.
            const bool isOfSome = row.bugs.descending != DescendingLine::Drawn
                && row.bugs.start != LineStart::FirstEnd;
            if (isOfSome)
                defects.back().choice = QString::fromLatin1(lineEndsChoice);
        }
    }
    return defects;
}

} // namespace pixelplumb
