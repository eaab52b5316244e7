// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/probesheet.h"

#include "core/grade/diagnose/diagnosis.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

/// Pictures of all scenes, and the defects that draw them.
struct PictureGroup {
    std::vector<Picture> pictures;
    AlikeDefects alike;
};

bool showSame(const std::vector<Picture> &one, const std::vector<Picture> &other)
{
    return std::ranges::equal(one, other, {}, &Picture::colours, &Picture::colours);
}

std::vector<Defect> allOf(std::span<const std::vector<Defect>> ofScenes)
{
    std::vector<Defect> all;
    for (const std::vector<Defect> &ofScene : ofScenes) {
        for (const Defect &defect : ofScene) {
            const bool isKnown = std::ranges::find(all, defect.id, &Defect::id) != all.end();
            if (!isKnown && !defect.isRightAlone)
                all.push_back(defect);
        }
    }
    return all;
}

} // namespace

std::size_t ProbeResult::distinct() const
{
    std::size_t hidden = 0;
    for (const AlikeDefects &group : alike)
        hidden += group.defects.size() - (group.equalRight ? 0 : 1);
    return defects + 1 - hidden;
}

ProbeResult probe(std::span<const Scene> scenes)
{
    std::vector<PictureGroup> groups(1);
    groups.front().alike.equalRight = true;
    for (const Scene &scene : scenes)
        groups.front().pictures.push_back(pictureOf(scene));
    std::vector<std::vector<Defect>> ofScenes;
    std::ranges::transform(scenes, std::back_inserter(ofScenes), defectsFor);
    ProbeResult result;
    for (const Defect &defect : allOf(ofScenes)) {
        ++result.defects;
        std::vector<Picture> pictures;
        for (std::size_t i = 0; i < scenes.size(); ++i)
            pictures.push_back(
                pictureWith(scenes[i], ownDefects(ofScenes[i], std::span(&defect, 1))));
        auto group = std::ranges::find_if(
            groups, [&](const PictureGroup &known) { return showSame(known.pictures, pictures); });
        if (group == groups.end())
            group = groups.insert(group, {std::move(pictures), {}});
        group->alike.defects.push_back(defect);
    }
    for (PictureGroup &group : groups) {
        if (group.alike.defects.size() + (group.alike.equalRight ? 1 : 0) > 1)
            result.alike.push_back(std::move(group.alike));
    }
    return result;
}

} // namespace pixelplumb
