// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/sampledspans.h"

#include "core/frame/framebuffer.h"
#include "core/grade/bugs/defectivescene.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/scan/redrawing.h"
#include "core/number/integer.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t largePicture = 1U << 15; // pixels; smaller ones are drawn whole as soon
constexpr std::size_t sampledEvenly = 8; // spans
constexpr std::size_t sampledWhereWrong = 8;

bool goesByColumns(const Scene &scene)
{
    return methodNamed(QString::fromStdString(scene.method))->spanAxis == SpanAxis::Column;
}

/// One column of a frame, or one row; the off-screen point stays where it is.
FrameSpec partOf(const Scene &scene, int span)
{
    FrameSpec part = scene.frame;
    const LatticePoint point = offScreenSample(part);
    const Lattice offset = sampleOffset(part);
    part.offScreenPoint = LatticePoint{point.x + offset, point.y + offset};
    if (goesByColumns(scene)) {
        part.firstColumn += span;
        part.width = 1;
    } else {
        part.firstRow += span;
        part.height = 1;
    }
    return part;
}

/// The same part of a picture of the whole frame.
Picture partOf(const Picture &picture, const Scene &scene, int span)
{
    const bool isColumn = goesByColumns(scene);
    Picture part{isColumn ? 1 : picture.width, isColumn ? picture.height : 1, {}, {}};
    part.hasColours = picture.hasColours;
    const int line = isColumn ? 0 : pictureLine(scene.frame, scene.frame.firstRow + span);
    const auto length = std::size_t(isColumn ? picture.height : picture.width);
    for (std::size_t i = 0; i < length; ++i) {
        const std::size_t place
            = isColumn ? picture.placeOf(span, int(i)) : picture.placeOf(int(i), line);
        part.colours.push_back(picture.colours[place]);
        part.covered.push_back(picture.covered[place]);
    }
    return part;
}

/// How many pixels of each span differ.
std::vector<std::int64_t> differingBySpan(const Picture &right, const Picture &found,
                                          const Scene &scene)
{
    const bool isColumn = goesByColumns(scene);
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
    std::int64_t all = 0;
    for (const std::int64_t each : differing)
        all += each;
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
        m_differing += differingPixels(*right, each.picture);
        m_differingInSpans
            += *differingIn(m_sampled.back(), {}, std::numeric_limits<std::int64_t>::max());
    }
    if (m_differingInSpans == 0)
        m_sampled.clear();
}

SampledSpans::SampledPicture SampledSpans::sampled(const FoundPicture &found,
                                                   const Picture &right) const
{
    const Scene &scene = m_pictures.scenes()[found.scene];
    SampledPicture sampled{found.scene, {}};
    for (const int span : chosenSpans(differingBySpan(right, found.picture, scene)))
        sampled.spans.push_back({partOf(scene, span), partOf(found.picture, scene, span)});
    return sampled;
}

std::optional<std::int64_t> SampledSpans::differingIn(const SampledPicture &sampled,
                                                      const DefectSet &set,
                                                      std::int64_t limit) const
{
    const std::vector<Defect> defects = m_pictures.ownDefectsIn(set, sampled.scene);
    const Scene &scene = m_pictures.scenes()[sampled.scene];
    Scene drawn = withDefects(scene, defects);
    const bool isTold = std::ranges::none_of(defects, &Defect::movesPixels)
        && (set.arithmetic.value_or(Arithmetic::Exact) == Arithmetic::Exact)
        && isDrawnInParts(drawn) && objectionTo(drawn).isEmpty();
    if (!isTold)
        return std::nullopt;
    std::int64_t differing = 0;
    const auto redrawing = redrawingAmong(defects);
    for (const SampledSpan &span : sampled.spans) {
        drawn.frame = span.part;
        Picture picture = redrawing ? redrawing->redraw(drawn) : pictureOf(drawn);
        for (const Defect &defect : defects) {
            if (defect.changePicture)
                picture = changed(picture, defect.changePicture, scene.frame.background);
        }
        m_pictures.countPart(picture.size());
        differing += differingPixels(picture, span.found, limit - differing);
        if (differing >= limit)
            break;
    }
    return differing;
}

std::optional<std::int64_t> SampledSpans::distance(const DefectSet &set, std::int64_t limit) const
{
    if (m_sampled.empty() || limit > m_differing)
        return std::nullopt;
    const std::int64_t most
        = std::max<std::int64_t>(1, ceilDivide(limit * m_differingInSpans, m_differing));
    std::int64_t differing = 0;
    for (const SampledPicture &sampled : m_sampled) {
        const auto here = differingIn(sampled, set, most - differing);
        if (!here)
            return std::nullopt;
        differing += *here;
        if (differing >= most)
            return limit;
    }
    return differing * m_differing / m_differingInSpans;
}

} // namespace pixelplumb
