// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/defectsearch.h"
#include "core/grade/scan/redrawing.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The scenes as this method draws them; empty where they are drawn likewise, or cannot be.
std::vector<Scene> scenesBy(const char *id, std::vector<Scene> scenes)
{
    const SpanAxis axis = methodNamed(QString::fromLatin1(id))->spanAxis;
    for (Scene &scene : scenes) {
        const Method &own = *methodNamed(QString::fromStdString(scene.method));
        const bool isOther = canBeRedrawn(scene) && own.spanAxis != axis;
        scene.method = id;
        scene.settings.variants = {};
        if (!isOther || !objectionTo(scene).isEmpty())
            return {};
    }
    return scenes;
}

Defect drawnByMethod(const char *id)
{
    const auto name = QString::fromLatin1(id);
    return {.id = u"drawn-by-"_s + name,
            .forStudent = u"Which method is asked for?"_s,
            .forAssistant
            = u"It is drawn by another method than the scenes', as by %1."_s.arg(name),
            .changeScene =
                [id](Scene &scene) {
                    scene.method = id;
                    scene.settings.variants = {};
                    return true;
                },
            .isRightAlone = true};
}

} // namespace

std::optional<std::vector<DiagnosisCandidate>> setsOfOtherMethods(
    const DefectPictures &pictures, std::span<const FoundPicture> found,
    const ProgressListener &listener, const Margin &margin)
{
    std::vector<DiagnosisCandidate> sets;
    for (const char *id : {"column-scan", "row-walk", "edge-equations"}) {
        std::vector<Scene> scenes = scenesBy(id, pictures.scenes());
        if (scenes.empty())
            continue;
        DefectPictures others(std::move(scenes));
        PictureMatcher matcher(others, found, margin);
        Diagnosis other;
        other.differing = matcher.distance({});
        DefectSearch search(others, matcher, other, listener, DefectSearch::Sought::Explanations);
        if (!search.run())
            return std::nullopt;
        for (DiagnosisCandidate &candidate : search.candidates()) {
            if (candidate.distance > 0)
                continue;
            candidate.defects.insert(candidate.defects.begin(), drawnByMethod(id));
            sets.push_back(std::move(candidate));
        }
    }
    return sets;
}

} // namespace pixelplumb
