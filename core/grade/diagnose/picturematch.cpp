// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/picturematch.h"

#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/sampledspans.h"
#include "core/grade/pictures/picturediff.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

namespace pixelplumb {

namespace {

DefectSet computedIn(DefectSet set, Arithmetic arithmetic)
{
    set.arithmetic = arithmetic;
    return set;
}

} // namespace

PictureMatcher::PictureMatcher(DefectPictures &pictures, std::span<const FoundPicture> found,
                               const Margin &margin)
    : m_pictures(pictures)
    , m_found(found)
    , m_margin(margin)
    , m_spans(std::make_unique<const SampledSpans>(pictures, found))
{
}

PictureMatcher::~PictureMatcher() = default;

bool PictureMatcher::isTolerated(Arithmetic arithmetic) const
{
    // What float32 may do, float64 may do too.
    return !m_margin.isStrict()
        && (m_margin.tolerance == arithmetic
            || (m_margin.tolerance == Arithmetic::Float32 && arithmetic == Arithmetic::Float64));
}

std::int64_t PictureMatcher::distance(const DefectSet &set, std::int64_t limit)
{
    const auto inSpans = m_spans->distance(set, limit);
    if (inSpans && *inSpans >= limit)
        return *inSpans;
    // What is known for a limit of 1 asks this, too.
    const bool isBeyond = limit != 1 && m_spans->areSampled()
        && std::ranges::any_of(m_found, [&](const FoundPicture &each) {
                              return m_pictures.isBeyond(each.scene, set, each.picture, limit);
                          });
    if (isBeyond)
        return limit;
    const auto isKnown = [&](const FoundPicture &each, std::int64_t upTo) {
        return upTo != unknown && m_pictures.isKnownToDiffer(each.scene, set, each.picture, upTo);
    };
    if (limit == 1
        && std::ranges::any_of(m_found, [&](const auto &each) { return isKnown(each, 1); }))
        return limit;
    std::int64_t distance = 0;
    for (const FoundPicture &each : m_found) {
        if (distance >= limit)
            break;
        if (limit != 1 && isKnown(each, limit - distance))
            return limit;
        const auto picture = m_pictures.picture(each.scene, set);
        if (!picture)
            return unknown;
        distance += differingPixels(*picture, each.picture, limit - distance);
    }
    return distance;
}

std::optional<std::int64_t> PictureMatcher::estimate(const DefectSet &set, std::int64_t limit) const
{
    return m_spans->distance(set, limit);
}

std::optional<SampledPart> PictureMatcher::sampledPart() const
{
    return m_spans->areSampled() ? std::optional(m_spans->part()) : std::nullopt;
}

std::int64_t PictureMatcher::mostOpen()
{
    std::int64_t covered = 0;
    std::int64_t onEdges = 0;
    for (const FoundPicture &each : m_found) {
        covered += std::ranges::count(m_pictures.picture(each.scene, {})->covered, 1);
        if (m_margin.leavesEdgesOpen())
            onEdges += std::ranges::count(tiesOf(m_pictures.scenes()[each.scene]), 1);
    }
    return covered / 8 + 8 + onEdges;
}

/// Differing pixels of one picture; none where the set fails to explain one of them.
std::optional<std::int64_t> PictureMatcher::openPixels(const DefectSet &set,
                                                       const FoundPicture &each)
{
    const auto own = m_pictures.picture(each.scene, set);
    if (!own)
        return std::nullopt;
    std::vector<DefectPictures::SharedPicture> drawn;
    for (const auto &[arithmetic, defect] : m_pictures.arithmetics()) {
        if (isTolerated(arithmetic))
            drawn.push_back(m_pictures.picture(each.scene, computedIn(set, arithmetic)));
    }
    std::erase(drawn, nullptr);
    DefectPictures::SharedRange range;
    std::int64_t open = 0;
    for (std::size_t place = 0; place < own->size(); ++place) {
        if (isSameAt(*own, each.picture, place))
            continue;
        ++open;
        const bool isDrawn = std::ranges::any_of(
            drawn, [&](const auto &picture) { return isSameAt(*picture, each.picture, place); });
        if (isDrawn)
            continue;
        if (!range)
            range = m_pictures.range(each.scene, set, m_margin);
        if (!range || !range->contains(each.picture, place))
            return std::nullopt;
    }
    return open;
}

/// Whether a defect changes the coverage of samples, also within the whole set, and none of these
/// samples is found so: then the defect is absent, even if rounding could explain each of them.
bool PictureMatcher::isUnseen(const DefectSet &part, const DefectSet &set)
{
    bool isClaimed = false;
    for (const FoundPicture &each : m_found) {
        const auto right = m_pictures.picture(each.scene, {});
        const auto alone = m_pictures.picture(each.scene, part);
        const auto whole = m_pictures.picture(each.scene, set);
        if (!alone || !whole)
            return false;
        for (std::size_t place = 0; place < right->size(); ++place) {
            const auto changed = alone->covered[place];
            if (changed == right->covered[place] || changed != whole->covered[place])
                continue;
            if (each.picture.covered[place] == changed)
                return false;
            isClaimed = true;
        }
    }
    return isClaimed;
}

bool PictureMatcher::hasUnseenPart(const DefectSet &set)
{
    const std::vector<Defect> &defects = m_pictures.defects();
    const std::array places = {set.first, set.second, set.choice};
    // A change of the background is no drawing.
    const bool isOfPicture = std::ranges::any_of(places, [&](const auto &place) {
        return place && defects[*place].stage() == DefectStage::Picture;
    });
    return !isOfPicture && std::ranges::any_of(places, [&](const auto &place) {
        return place && isUnseen({place}, set);
    });
}

bool PictureMatcher::isDrawnAllTheSame(const DefectSet &set)
{
    for (const auto &part : {set.first, set.second}) {
        if (!part || !m_pictures.defects()[*part].leavesOut)
            continue;
        for (const FoundPicture &each : m_found) {
            const auto right = m_pictures.picture(each.scene, {});
            const auto alone = m_pictures.picture(each.scene, {part});
            const auto whole = m_pictures.picture(each.scene, set);
            for (std::size_t place = 0; alone && whole && place < right->size(); ++place) {
                if (right->covered[place] != 0 && alone->covered[place] == 0
                    && !isSameAt(*whole, each.picture, place))
                    return true;
            }
        }
    }
    return false;
}

bool PictureMatcher::drawsNothingTogether(const DefectSet &set)
{
    const auto drawsNothing = [this](const DefectSet &some) {
        return std::ranges::all_of(m_found, [&](const FoundPicture &each) {
            const auto picture = m_pictures.picture(each.scene, some);
            const Picture empty = emptyPicture(m_pictures.scenes()[each.scene].frame);
            return picture && differingPixels(empty, *picture, 1) == 0;
        });
    };
    return set.second && drawsNothing(set) && !drawsNothing({set.first})
        && !drawsNothing({set.second});
}

bool PictureMatcher::leavesFewLevels(const DefectSet &set)
{
    constexpr std::size_t handful = 4;
    std::set<std::pair<std::uint8_t, std::uint8_t>> changes; // of a level to another
    for (const FoundPicture &each : m_found) {
        const auto picture = m_pictures.picture(each.scene, set);
        if (!picture || !each.picture.hasColours)
            return false;
        for (std::size_t place = 0; place < picture->size(); ++place) {
            const Colour &is = each.picture.colours[place];
            const Colour &should = picture->colours[place];
            for (std::size_t i = 0; i < 3; ++i) {
                const int error = std::abs(int(is.channels[i]) - int(should.channels[i]));
                if (error > 1)
                    return false;
                if (error == 1)
                    changes.emplace(should.channels[i], is.channels[i]);
            }
            if (changes.size() > handful)
                return false;
        }
    }
    return !changes.empty();
}

bool PictureMatcher::isByChance(const DefectSet &set)
{
    const auto isLeftLittle = [&](const std::optional<std::size_t> &part) {
        return leavesFewLevels({.first = part, .arithmetic = set.arithmetic});
    };
    return set.first
        && (isLeftLittle(std::nullopt)
            || (set.second && (isLeftLittle(set.first) || isLeftLittle(set.second))));
}

std::optional<SetMatch> PictureMatcher::allowedMatch(const DefectSet &set)
{
    if (m_margin.isStrict())
        return std::nullopt;
    for (const auto &[arithmetic, defect] : m_pictures.arithmetics()) {
        const DefectSet computed = computedIn(set, arithmetic);
        if (isTolerated(arithmetic) && distance(computed, 1) == 0)
            return SetMatch{computed};
    }
    SetMatch match{set};
    for (const FoundPicture &each : m_found) {
        const auto open = openPixels(set, each);
        if (!open)
            return std::nullopt;
        match.undecidable += *open;
    }
    return hasUnseenPart(set) ? std::nullopt : std::optional(match);
}

std::vector<Arithmetic> PictureMatcher::equalIn(const DefectSet &set)
{
    std::vector<Arithmetic> equal;
    for (const auto &[arithmetic, defect] : m_pictures.arithmetics()) {
        if (distance(computedIn(set, arithmetic), 1) == 0)
            equal.push_back(arithmetic);
    }
    return equal;
}

} // namespace pixelplumb
