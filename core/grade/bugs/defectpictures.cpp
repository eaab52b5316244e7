// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/defectpictures.h"

#include "core/grade/bugs/defectivescene.h"
#include "core/grade/scan/redrawing.h"
#include "core/runs/scenerun.h"

#include <QHash>
#include <QSet>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr std::size_t mostKept = std::size_t(256) << 20; // bytes

std::size_t bytesOf(const Picture &picture)
{
    return picture.size() * (sizeof(Colour) + sizeof(std::uint8_t));
}

/// isSameAt(), of a pixel that is in no picture yet.
bool isSameAs(const ChangedPixel &pixel, const Picture &found, std::size_t place)
{
    return found.hasColours ? isEqual(pixel.colour, found.colours[place])
                            : pixel.covered == found.covered[place];
}

template <class T>
std::size_t hashOf(const std::vector<T> &values)
{
    return qHashBits(values.data(), values.size() * sizeof(T));
}

} // namespace

DefectPictures::DefectPictures(std::vector<Scene> scenes)
    : m_scenes(std::move(scenes))
    , m_lastScenePicture(m_scenes.size())
    , m_lastBase(m_scenes.size())
{
    QSet<QString> ids;
    for (const Scene &scene : m_scenes) {
        m_ofScene.push_back(defectsFor(scene));
        for (const Defect &defect : m_ofScene.back()) {
            if (defect.choice == QLatin1String(arithmeticChoice)) {
                Scene changed = scene;
                defect.changeScene(changed);
                m_arithmetics.emplace(changed.settings.arithmetic, defect);
            } else if (!ids.contains(defect.id)) {
                ids += defect.id;
                m_defects.push_back(defect);
            }
        }
    }
    // In a pair, the defect with the earlier stage comes first.
    std::ranges::stable_sort(m_defects, {}, &Defect::stage);
    QHash<QString, std::size_t> places;
    for (std::size_t place = 0; place < m_defects.size(); ++place)
        places.insert(m_defects[place].id, place);
    for (const std::vector<Defect> &ofScene : m_ofScene) {
        auto &ownPlaces = m_ownPlaces.emplace_back(m_defects.size());
        for (std::size_t i = 0; i < ofScene.size(); ++i) {
            if (const auto place = places.constFind(ofScene[i].id); place != places.constEnd())
                ownPlaces[*place] = i;
        }
    }
}

const Defect *DefectPictures::own(std::size_t scene, std::size_t defect) const
{
    const std::optional<std::size_t> place = m_ownPlaces[scene][defect];
    return place ? &m_ofScene[scene][*place] : nullptr;
}

std::vector<Defect> DefectPictures::defectsIn(const DefectSet &set) const
{
    std::vector<Defect> defects;
    for (const auto &place : {set.first, set.second, set.choice}) {
        if (place)
            defects.push_back(m_defects[*place]);
    }
    return defects;
}

std::vector<Defect> DefectPictures::ownDefectsIn(const DefectSet &set, std::size_t scene) const
{
    std::vector<Defect> defects;
    for (const auto &place : {set.first, set.second, set.choice}) {
        if (const Defect *defect = place ? own(scene, *place) : nullptr)
            defects.push_back(*defect);
    }
    return defects;
}

/// The picture of the scene with those of the defects that change scenes. The last one drawn is
/// kept, since sets that differ only in defects of the picture follow one another.
DefectPictures::SharedPicture DefectPictures::scenePicture(std::size_t scene, const Scene &drawn)
{
    LastPicture &last = m_lastScenePicture[scene];
    {
        const std::lock_guard lock(m_mutex);
        if (last.scene == drawn)
            return last.picture;
    }
    SharedPicture picture;
    if (objectionTo(drawn).isEmpty())
        picture = std::make_shared<const Picture>(pictureOf(drawn));
    const std::lock_guard lock(m_mutex);
    last = {drawn, picture};
    return picture;
}

Scene DefectPictures::sceneIn(std::size_t scene, const DefectSet &set) const
{
    Scene drawn = m_scenes[scene];
    drawn.settings.arithmetic = set.arithmetic.value_or(drawn.settings.arithmetic);
    return drawn;
}

DefectPictures::SharedPicture DefectPictures::draw(std::size_t scene, const DefectSet &set)
{
    if (set.second && m_defects[*set.second].changePicture)
        return changed(scene, set);
    const std::vector<Defect> defects = ownDefectsIn(set, scene);
    const Scene drawn = withDefects(sceneIn(scene, set), defects);
    const auto redrawing = redrawingAmong(defects);
    SharedPicture picture;
    if (!redrawing)
        picture = scenePicture(scene, drawn);
    else if (objectionTo(drawn).isEmpty())
        picture = std::make_shared<const Picture>(redrawing->redraw(drawn));
    for (const Defect &defect : defects) {
        if (picture && defect.changePicture)
            picture = std::make_shared<const Picture>(
                pixelplumb::changed(*picture, defect.changePicture, drawn.frame.background));
    }
    return picture;
}

/// The picture of the set's first defect, which many sets share, changed by the second.
DefectPictures::SharedPicture DefectPictures::changed(std::size_t scene, const DefectSet &set)
{
    const Base base = baseOf(scene, set);
    const Defect *change = own(scene, *set.second);
    if (!base.picture || !change)
        return base.picture;
    return std::make_shared<const Picture>(
        pixelplumb::changed(*base.picture, change->changePicture, base.background));
}

/// The picture of the set without its change of the picture. The last one is kept: sets with one
/// first defect follow one another.
DefectPictures::Base DefectPictures::baseOf(std::size_t scene, const DefectSet &set)
{
    const DefectSet first{set.first, {}, set.arithmetic, set.choice};
    {
        const std::lock_guard lock(m_mutex);
        if (m_lastBase[scene].set == first)
            return m_lastBase[scene];
    }
    const Scene drawn = withDefects(sceneIn(scene, set), ownDefectsIn(first, scene));
    const Base base{first, picture(scene, first), drawn.frame.background};
    const std::lock_guard lock(m_mutex);
    return m_lastBase[scene] = base;
}

bool DefectPictures::isBeyond(std::size_t scene, const DefectSet &set, const Picture &found,
                              std::int64_t limit)
{
    constexpr std::size_t asked = 1024; // pixels
    const Defect *change = set.second ? own(scene, *set.second) : nullptr;
    const Base base = change && change->changePicture ? baseOf(scene, set) : Base();
    if (!base.picture || base.picture->size() != found.size())
        return false;
    const std::size_t stride = found.size() / asked + 1;
    double differing = 0;
    for (std::size_t place = stride / 2; place < found.size(); place += stride) {
        const auto width = std::size_t(found.width);
        ChangedPixel pixel;
        change->changePicture(*base.picture, int(place % width), int(place / width),
                              base.background, std::span(&pixel, 1));
        const bool isSame = isSameAs(pixel, found, place);
        differing += isSame ? 0 : 1;
        // Three standard deviations less than as many as are seen.
        const double least = (differing - 3 * std::sqrt(differing)) * double(stride);
        if (!isSame && (limit == 1 || least >= double(limit)))
            return true;
    }
    return false;
}

DefectPictures::SharedPicture DefectPictures::picture(std::size_t scene, const DefectSet &set)
{
    const Key key(scene, set);
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_drawn.find(key);
        if (found != m_drawn.end() && (found->second.picture || !found->second.canBeDrawn))
            return found->second.picture;
    }
    SharedPicture picture = draw(scene, set);
    m_pictures += picture ? 1 : 0;
    m_pixels += picture ? std::int64_t(picture->size()) : 0;
    Drawn drawn;
    drawn.canBeDrawn = bool(picture);
    if (picture) {
        drawn.colourHash = hashOf(picture->colours);
        drawn.coverageHash = hashOf(picture->covered);
    }
    const std::lock_guard lock(m_mutex);
    const auto [place, isNew] = m_drawn.emplace(key, drawn);
    if (isNew && picture && m_kept + bytesOf(*picture) <= mostKept) {
        place->second.picture = picture;
        m_kept += bytesOf(*picture);
    }
    return picture;
}

DefectPictures::SharedRange DefectPictures::range(std::size_t scene, const DefectSet &set,
                                                  const Margin &margin)
{
    const std::tuple key(Key(scene, set), margin.leeway, margin.tolerance);
    {
        const std::lock_guard lock(m_mutex);
        if (const auto found = m_ranges.find(key); found != m_ranges.end())
            return found->second;
    }
    SharedRange range;
    if (auto drawn = rangeWith(m_scenes[scene], ownDefectsIn(set, scene), margin))
        range = std::make_shared<const PictureRange>(*std::move(drawn));
    const std::size_t bytes = range ? 5 * bytesOf(range->sides.front()) : 0;
    const std::lock_guard lock(m_mutex);
    if (m_kept + bytes <= mostKept && m_ranges.emplace(key, range).second)
        m_kept += bytes;
    return range;
}

bool DefectPictures::Drawn::isKnownToDiffer(const Picture &found) const
{
    if (picture || !canBeDrawn)
        return !canBeDrawn;
    return found.hasColours ? colourHash != hashOf(found.colours)
                            : coverageHash != hashOf(found.covered);
}

bool DefectPictures::isRefusedAtOnce(std::size_t scene, const DefectSet &set, const Picture &found,
                                     std::int64_t limit) const
{
    const std::vector<Defect> defects = ownDefectsIn(set, scene);
    const bool isOfPictures
        = std::ranges::find(defects, DefectStage::Picture, &Defect::stage) != defects.end();
    const auto redrawing = isOfPictures ? std::nullopt : redrawingAmong(defects);
    if (!redrawing || !redrawing->redrawing)
        return false;
    const Scene drawn = withDefects(sceneIn(scene, set), defects);
    return objectionTo(drawn).isEmpty()
        && differsAtOnce(drawn, *redrawing->redrawing, found, limit);
}

/// Of a set with a change of the finished picture, which is not made where too much differs.
bool DefectPictures::isRefusedWhenChanged(std::size_t scene, const DefectSet &set,
                                          const Picture &found, std::int64_t limit)
{
    if (limit == 1)
        return isBeyond(scene, set, found, 1);
    const Base base = baseOf(scene, set);
    const Defect *change = own(scene, *set.second);
    if (!base.picture || !change || base.picture->size() != found.size())
        return false;
    std::int64_t differing = 0;
    std::size_t place = 0;
    std::vector<ChangedPixel> pixels(std::size_t(found.width));
    for (int line = 0; line < found.height && differing < limit; ++line) {
        change->changePicture(*base.picture, 0, line, base.background, pixels);
        for (const ChangedPixel &pixel : pixels)
            differing += isSameAs(pixel, found, place++) ? 0 : 1;
    }
    return differing >= limit;
}

bool DefectPictures::isKnownToDiffer(std::size_t scene, const DefectSet &set, const Picture &found,
                                     std::int64_t limit)
{
    {
        const std::lock_guard lock(m_mutex);
        const auto known = m_drawn.find({scene, set});
        if (known != m_drawn.end() && (limit == 1 || known->second.picture))
            return limit == 1 && known->second.isKnownToDiffer(found);
        if (known != m_drawn.end() && !known->second.canBeDrawn)
            return false;
    }
    if (set.second && m_defects[*set.second].changePicture)
        return isRefusedWhenChanged(scene, set, found, limit);
    return isRefusedAtOnce(scene, set, found, limit);
}

} // namespace pixelplumb
