// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/defectivescene.h"

#include "core/grade/pictures/picturediff.h"
#include "core/grade/scan/redrawing.h"
#include "core/runs/scenerun.h"
#include "core/scan/scanbugs.h"

#include <algorithm>

namespace pixelplumb {

namespace {

Picture finished(Picture picture, std::span<const Defect> defects, const Colour &background)
{
    for (const Defect &defect : defects) {
        if (defect.changePicture)
            picture = changed(picture, defect.changePicture, background);
    }
    return picture;
}

} // namespace

Scene withDefects(Scene scene, std::span<const Defect> defects)
{
    for (const Defect &defect : defects) {
        if (defect.changeScene)
            defect.changeScene(scene);
    }
    return scene;
}

Scene steppedWithDefects(const Scene &scene, std::span<const Defect> defects)
{
    Scene stepped = withDefects(scene, defects);
    const auto redrawing = redrawingAmong(defects);
    if (!redrawing || !redrawing->redrawing)
        return stepped;
    if (const auto &walk = redrawing->redrawing->walk)
        stepped.settings.bugs = *walk;
    const bool areTests = std::ranges::all_of(defects, [](const Defect &defect) {
        return defect.stage() != DefectStage::Drawing
            || (defect.redrawing && defect.redrawing->edgeTest);
    });
    const Method &method = *methodNamed(QString::fromStdString(stepped.method));
    const bool isExact = stepped.settings.arithmetic == Arithmetic::Exact; // as its numbers are
    if (areTests && isExact && method.testsEdges)
        stepped.settings.testBugs = *redrawing->redrawing->edgeTest;
    return stepped;
}

std::optional<Defect> redrawingAmong(std::span<const Defect> defects)
{
    std::optional<Defect> among;
    for (const Defect &defect : defects) {
        if (defect.stage() != DefectStage::Drawing)
            continue;
        if (!among) {
            among = defect;
            continue;
        }
        if (auto both = drawnTogether(*among, defect))
            among = *std::move(both);
    }
    return among;
}

Picture pictureWith(const Scene &scene, std::span<const Defect> defects)
{
    const Scene drawn = withDefects(scene, defects);
    const auto redrawing = redrawingAmong(defects);
    return finished(redrawing ? redrawing->redraw(drawn) : pictureOf(drawn), defects,
                    scene.frame.background);
}

std::optional<PictureRange> rangeWith(const Scene &scene, std::span<const Defect> defects,
                                      const Margin &margin)
{
    const Scene drawn = withDefects(scene, defects);
    const auto redrawing = redrawingAmong(defects);
    const bool isKnown = canBeRedrawn(drawn) && objectionTo(drawn).isEmpty()
        && (!redrawing || redrawing->redrawRange);
    if (!isKnown)
        return std::nullopt;
    const Redrawing asItIs{[](TriangleRuns &) {}};
    PictureRange range = redrawing ? redrawing->redrawRange(drawn, margin.tolerance)
                                   : redrawnRange(drawn, asItIs, margin.tolerance);
    if (margin.leavesEdgesOpen()) {
        Picture open = emptyPicture(drawn.frame);
        open.covered = tiesOf(drawn);
        range.openEdges = finished(std::move(open), defects, scene.frame.background);
    }
    for (Picture &side : range.sides)
        side = finished(std::move(side), defects, scene.frame.background);
    return range;
}

} // namespace pixelplumb
