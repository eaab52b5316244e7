// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/sampledspans.h"

#include "core/frame/framebuffer.h"
#include "core/grade/bugs/defectivescene.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/scan/redrawing.h"
#include "core/number/integer.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace pixelplumb {

namespace {

constexpr std::size_t sampledEvenly = 8; // spans
constexpr std::size_t sampledWhereWrong = 8;

SpanAxis axisOf(const Scene &scene)
{
    return methodNamed(QString::fromStdString(scene.method))->spanAxis;
}

/// How many pixels of each span differ.
std::vector<std::int64_t> differingBySpan(const Picture &right, const Picture &found,
                                          const Scene &scene)
{
    const bool isColumn = axisOf(scene) == SpanAxis::Column;
    std::vector<std::int64_t> differing(std::size_t(isColumn ? found.width : found.height), 0);
    for (int line = 0; line < found.height; ++line) {
        const auto row = std::size_t(rowOfPictureLine(scene.frame, line) - scene.frame.firstRow);
        for (int x = 0; x < found.width; ++x)
            differing[isColumn ? std::size_t(x) : row]
                += isSameAt(right, found, found.placeOf(x, line)) ? 0 : 1;
    }
    return differing;
}

/// Spans between which as many pixels differ, then spans at equal distances.
std::vector<int> chosenSpans(const std::vector<std::int64_t> &differing)
{
    std::vector<int> chosen;
    const auto choose = [&](std::size_t span) {
        if (std::ranges::find(chosen, int(span)) == chosen.end())
            chosen.push_back(int(span));
    };
    const std::int64_t all = std::reduce(differing.begin(), differing.end());
    std::int64_t before = 0;
    std::size_t next = 0;
    for (std::size_t span = 0; span < differing.size(); ++span) {
        before += differing[span];
        const std::size_t reached = next;
        while (next < sampledWhereWrong
               && before * std::int64_t(sampledWhereWrong) > all * std::int64_t(next))
            ++next;
        if (next > reached)
            choose(span);
    }
    for (std::size_t i = 0; i < sampledEvenly; ++i)
        choose((2 * i + 1) * differing.size() / (2 * sampledEvenly));
    return chosen;
}

/// Whether a part of the picture is drawn as in the whole: numbers that round are stepped from the
/// frame's first span on.
bool isDrawnInParts(const Scene &scene)
{
    return canBeRedrawn(scene) && scene.settings.arithmetic == Arithmetic::Exact;
}

} // namespace

SampledSpans::SampledSpans(DefectPictures &pictures, std::span<const FoundPicture> found)
    : m_pictures(pictures)
{
    std::size_t pixels = 0;
    for (const FoundPicture &each : found) {
        pixels += each.picture.size();
        if (!isDrawnInParts(pictures.scenes()[each.scene]))
            return;
    }
    if (pixels < largePicture)
        return;
    for (const FoundPicture &each : found) {
        const auto right = pictures.picture(each.scene, {});
        if (!right || right->size() != each.picture.size()) {
            m_sampled.clear();
            return;
        }
        m_sampled.push_back(sampled(each, *right));
        const FrameSpec &frame = pictures.scenes()[each.scene].frame;
        const ChosenSpans &chosen = m_sampled.back().chosen;
        m_part.spans += chosen.spans().size();
        m_part.of += std::size_t(chosen.areColumns() ? frame.width : frame.height);
        m_few.push_back(fewOf(m_sampled.back(), frame, each.picture));
        m_differing += differingPixels(*right, each.picture);
    }
    constexpr auto all = std::numeric_limits<std::int64_t>::max();
    m_differingInSpans = *differingIn(m_sampled, {}, all);
    m_differingInFew = *differingIn(m_few, {}, all);
    if (m_differingInSpans == 0)
        m_sampled.clear();
}

SampledSpans::SampledPicture SampledSpans::sampled(const FoundPicture &found,
                                                   const Picture &right) const
{
    const Scene &scene = m_pictures.scenes()[found.scene];
    const SpanAxis axis = axisOf(scene);
    const std::int64_t first
        = axis == SpanAxis::Column ? scene.frame.firstColumn : scene.frame.firstRow;
    std::vector<std::int64_t> spans;
    for (const int span : chosenSpans(differingBySpan(right, found.picture, scene)))
        spans.push_back(first + span);
    std::ranges::sort(spans);
    const auto with = [&](const ChosenSpans &some) {
        return SampledPicture{found.scene, some, partOf(found.picture, scene.frame, some)};
    };
    SampledPicture sampled = with({axis, spans});
    for (const std::int64_t span : spans)
        sampled.spans.push_back(with({axis, {span}}));
    return sampled;
}

SampledSpans::SampledPicture SampledSpans::fewOf(const SampledPicture &sampled,
                                                 const FrameSpec &frame, const Picture &found)
{
    std::vector<std::int64_t> spans;
    const std::vector<std::int64_t> &all = sampled.chosen.spans();
    for (std::size_t i = std::min<std::size_t>(1, all.size() - 1); i < all.size(); i += 4)
        spans.push_back(all[i]);
    const ChosenSpans chosen(sampled.chosen.axis(), std::move(spans));
    return {sampled.scene, chosen, partOf(found, frame, chosen)};
}

/// The spans from which a shift by a pixel or a flip takes these.
ChosenSpans SampledSpans::aroundOf(const ChosenSpans &chosen, const FrameSpec &frame)
{
    const std::int64_t first = chosen.areColumns() ? frame.firstColumn : frame.firstRow;
    const std::int64_t last = first + (chosen.areColumns() ? frame.width : frame.height) - 1;
    std::set<std::int64_t> around;
    for (const std::int64_t span : chosen.spans()) {
        for (const std::int64_t beside : {span - 1, span, span + 1}) {
            around.insert(std::clamp(beside, first, last));
            around.insert(std::clamp(first + last - beside, first, last));
        }
    }
    return {chosen.axis(), {around.begin(), around.end()}};
}

Picture SampledSpans::drawn(const SampledPicture &sampled, const Scene &scene,
                            const std::optional<Defect> &redrawing) const
{
    m_pictures.countPart(sampled.found.size());
    return redrawing ? redrawn(scene, *redrawing->redrawing, &sampled.chosen)
                     : pictureOf(scene, sampled.chosen);
}

/// Sets with a change of the picture follow one another: what the last one was a change of is kept.
const Picture &SampledSpans::baseOf(const SampledPicture &sampled, const DefectSet &set,
                                    const Scene &scene,
                                    const std::optional<Defect> &redrawing) const
{
    const auto key = std::pair(&sampled, DefectSet{set.first, {}, set.arithmetic, set.choice});
    if (m_lastBase.first != key)
        m_lastBase = {key, drawn(sampled, scene, redrawing)};
    return m_lastBase.second;
}

std::optional<std::int64_t> SampledSpans::differingIn(const SampledPicture &sampled,
                                                      const DefectSet &set,
                                                      std::int64_t limit) const
{
    const std::vector<Defect> defects = m_pictures.ownDefectsIn(set, sampled.scene);
    const Scene &scene = m_pictures.scenes()[sampled.scene];
    const Scene changedScene = withDefects(scene, defects);
    const bool isTold = std::ranges::none_of(defects, &Defect::movesPixels)
        && (set.arithmetic.value_or(Arithmetic::Exact) == Arithmetic::Exact)
        && isDrawnInParts(changedScene) && objectionTo(changedScene).isEmpty();
    if (!isTold)
        return std::nullopt;
    const auto redrawing = redrawingAmong(defects);
    const auto change = std::ranges::find_if(
        defects, [](const Defect &defect) { return bool(defect.changePicture); });
    if (change != defects.end()) {
        const bool isShared = set.second && change + 1 == defects.end() && !set.choice;
        const Picture &base = isShared
            ? baseOf(sampled, set, changedScene, redrawing)
            : (m_lastBase = {{}, drawn(sampled, changedScene, redrawing)}).second;
        Picture picture = base;
        for (auto each = change; each != defects.end(); ++each)
            picture = changed(picture, each->changePicture, scene.frame.background);
        return differingPixels(picture, sampled.found, limit);
    }
    const auto isRefused = [&](const SampledPicture &some, std::int64_t most) {
        return redrawing
            && differsAtOnce(changedScene, *redrawing->redrawing, some.found, most, &some.chosen);
    };
    const auto differingPart = [&](const SampledPicture &some, std::int64_t most) {
        return isRefused(some, most)
            ? most
            : differingPixels(drawn(some, changedScene, redrawing), some.found, most);
    };
    const bool isWalk = redrawing && redrawing->redrawing->walk;
    if (limit > 1 || isWalk)
        return differingPart(sampled, limit);
    std::int64_t differing = 0;
    for (const SampledPicture &span : sampled.spans) {
        if (differing < limit)
            differing += differingPart(span, limit - differing);
    }
    return differing;
}

std::optional<std::int64_t> SampledSpans::differingMoved(std::size_t index, const DefectSet &set,
                                                         std::int64_t limit) const
{
    constexpr std::uint8_t unknown = 2; // in place of covered or not
    const SampledPicture &few = m_few[index];
    const Scene &scene = m_pictures.scenes()[few.scene];
    const std::vector<Defect> defects = m_pictures.ownDefectsIn(set, few.scene);
    if (defects.empty() || !defects.back().movesPixels || set.choice)
        return std::nullopt;
    const std::span first(defects.data(), defects.size() - 1);
    const Scene changedScene = withDefects(scene, first);
    const bool isTold
        = std::ranges::none_of(first, [](const Defect &each) { return bool(each.changePicture); })
        && set.arithmetic.value_or(Arithmetic::Exact) == Arithmetic::Exact
        && isDrawnInParts(changedScene) && objectionTo(changedScene).isEmpty();
    if (!isTold)
        return std::nullopt;
    const DefectSet base = set.second ? DefectSet{set.first} : DefectSet();
    if (const auto key = std::pair(&few, base); m_lastMoved.first != key) {
        const ChosenSpans around = aroundOf(few.chosen, scene.frame);
        Picture picture = emptyPicture(scene.frame);
        std::ranges::fill(picture.covered, unknown);
        copyTo(picture, scene.frame, around,
               drawn({few.scene, around, {}}, changedScene, redrawingAmong(first)));
        m_lastMoved = {key, std::move(picture)};
    }
    // What becomes of the picture's places, of which those of these spans are asked for.
    std::int64_t differing = 0;
    ChangedPixel pixel;
    forEachPlace(few.chosen, scene.frame, [&](int x, int line, std::size_t place) {
        if (differing >= limit)
            return;
        defects.back().changePicture(m_lastMoved.second, x, line, changedScene.frame.background,
                                     std::span(&pixel, 1));
        const bool isSame = few.found.hasColours ? isEqual(pixel.colour, few.found.colours[place])
                                                 : pixel.covered == few.found.covered[place];
        differing += pixel.covered == unknown || isSame ? 0 : 1;
    });
    return differing;
}

std::optional<std::int64_t> SampledSpans::distance(const DefectSet &set, std::int64_t limit) const
{
    if (m_sampled.empty() || limit > m_differing)
        return std::nullopt;
    // Few of the spans refuse what leaves clearly more, so that the others are not drawn.
    const auto shareOf = [&](std::int64_t ofThese) {
        return ceilDivide<Int128>(Int128(limit) * ofThese, m_differing);
    };
    const auto mostInFew = limit == 1 ? 1 : std::int64_t(5 * shareOf(m_differingInFew) / 4 + 8);
    for (std::size_t i = 0; i < m_few.size(); ++i) {
        if (differingMoved(i, set, mostInFew).value_or(0) >= mostInFew)
            return limit;
    }
    if (limit > 1) {
        const auto inFew = differingIn(m_few, set, mostInFew);
        if (inFew && *inFew >= mostInFew)
            return limit;
    }
    const std::int64_t most = std::max<std::int64_t>(1, std::int64_t(shareOf(m_differingInSpans)));
    const auto differing = differingIn(m_sampled, set, most);
    if (!differing || *differing >= most)
        return differing ? std::optional(limit) : std::nullopt;
    return *differing * m_differing / m_differingInSpans;
}

std::optional<std::int64_t> SampledSpans::differingIn(const std::vector<SampledPicture> &pictures,
                                                      const DefectSet &set,
                                                      std::int64_t limit) const
{
    std::int64_t differing = 0;
    for (const SampledPicture &sampled : pictures) {
        if (differing >= limit)
            break;
        const auto here = differingIn(sampled, set, limit - differing);
        if (!here)
            return std::nullopt;
        differing += *here;
    }
    return differing;
}

} // namespace pixelplumb
