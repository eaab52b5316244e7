// SPDX-License-Identifier: GPL-3.0-or-later
#include "picturecheck.h"

#include "core/frame/framebuffer.h"
#include "core/oracle/oracle.h"

#include <algorithm>

namespace pixelplumb::bench {

namespace {

/// The truth costs about 20 ns per pixel of each triangle's box, under each rule.
constexpr std::int64_t mostBoxPixels = 4'000'000;
constexpr std::int64_t mostBoxPixelsWhenQuick = 500'000;
constexpr std::size_t mostCandidates = 20'000;
/// px beyond a triangle's box that renderers write because they antialias or round differently.
constexpr int margin = 2;

struct Box {
    int left, right, low, high; ///< all inclusive
};

Box boxOf(const Triangle &triangle, FrameSize size)
{
    Box box = {size.width, 0, size.height, 0};
    for (const Vertex &vertex : triangle.vertices) {
        const PixelPoint point = pixelOf(vertex);
        box.left = std::min(box.left, point.x);
        box.right = std::max(box.right, point.x);
        box.low = std::min(box.low, point.y);
        box.high = std::max(box.high, point.y);
    }
    return {std::max(box.left - margin, 0), std::min(box.right + margin, size.width - 1),
            std::max(box.low - margin, 0), std::min(box.high + margin, size.height - 1)};
}

/// The first triangles whose boxes do not touch.
std::vector<Triangle> apart(const Workload &workload, std::int64_t mostPixels)
{
    const auto width = std::size_t(workload.size.width);
    std::vector<bool> taken(width * std::size_t(workload.size.height), false);
    std::vector<Triangle> chosen;
    std::int64_t boxPixels = 0;
    const std::size_t candidates = std::min(workload.triangles.size(), mostCandidates);
    for (const Triangle &triangle : std::span(workload.triangles).first(candidates)) {
        const Box box = boxOf(triangle, workload.size);
        const auto rowAt = [&](int y) { return taken.begin() + std::ptrdiff_t(y) * int(width); };
        bool free = true;
        for (int y = box.low; free && y <= box.high; ++y)
            free = std::find(rowAt(y) + box.left, rowAt(y) + box.right + 1, true)
                == rowAt(y) + box.right + 1;
        if (!free)
            continue;
        for (int y = box.low; y <= box.high; ++y)
            std::fill(rowAt(y) + box.left, rowAt(y) + box.right + 1, true);
        chosen.push_back(triangle);
        boxPixels += std::int64_t(box.right - box.left + 1) * (box.high - box.low + 1);
        if (boxPixels > mostPixels)
            break;
    }
    return chosen;
}

} // namespace

std::vector<Triangle> seenBy(std::span<const Triangle> triangles, const TieRule &rule,
                             const LatticePoint &sampleOffset, FrameSize size)
{
    std::vector<Triangle> seen(triangles.begin(), triangles.end());
    for (Triangle &triangle : seen) {
        for (Vertex &vertex : triangle.vertices) {
            LatticePoint &position = vertex.position;
            position.x -= sampleOffset.x;
            position.y -= sampleOffset.y;
            if (rule.mirrorsColumns)
                position.x = Lattice(size.width - 1) * unitsPerPixel - position.x;
            if (rule.mirrorsRows)
                position.y = Lattice(size.height - 1) * unitsPerPixel - position.y;
        }
    }
    return seen;
}

namespace {

Picture truthOf(FrameSize size, std::span<const Triangle> triangles, const TieRule &rule)
{
    FrameSpec spec;
    spec.width = size.width;
    spec.height = size.height;
    FrameBuffer frame(spec);
    for (const Triangle &triangle : triangles)
        oracle::draw(triangle, rule.rule, ByteRounding::Nearest, frame.view());
    const QImage image = frame.image();
    Picture seen = pictureOfLines(size, image.constBits(), image.bytesPerLine());
    if (!rule.mirrorsColumns && !rule.mirrorsRows)
        return seen;
    Picture picture(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            picture.set(x, y,
                        seen.at(rule.mirrorsColumns ? size.width - 1 - x : x,
                                rule.mirrorsRows ? size.height - 1 - y : y));
        }
    }
    return picture;
}

bool isMoreThanOneLevelOff(std::uint32_t a, std::uint32_t b)
{
    const auto off = [](int x, int y) { return std::abs(x - y) > 1; };
    return off(qRed(a), qRed(b)) || off(qGreen(a), qGreen(b)) || off(qBlue(a), qBlue(b));
}

PictureDifference difference(const Picture &picture, const Picture &truth, const TieRule &rule)
{
    std::int64_t covered = 0;
    std::int64_t coverage = 0;
    std::int64_t colour = 0;
    std::int64_t bytes = 0;
    const FrameSize size = truth.size();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t is = picture.at(x, y);
            const std::uint32_t shouldBe = truth.at(x, y);
            covered += shouldBe != 0 ? 1 : 0;
            bytes += is != shouldBe ? 1 : 0;
            if ((is != 0) != (shouldBe != 0))
                ++coverage;
            else
                colour += isMoreThanOneLevelOff(is, shouldBe) ? 1 : 0;
        }
    }
    const double all = double(std::max<std::int64_t>(covered, 1));
    return {rule, double(coverage) / all, double(colour) / all, double(bytes) / all};
}

} // namespace

double differingShare(const Picture &a, const Picture &b)
{
    std::int64_t written = 0;
    std::int64_t different = 0;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            written += (a.at(x, y) | b.at(x, y)) != 0 ? 1 : 0;
            different += a.at(x, y) != b.at(x, y) ? 1 : 0;
        }
    }
    return double(different) / double(std::max<std::int64_t>(written, 1));
}

PictureCheck::PictureCheck(const Workload &workload, Extent extent)
    : m_size(workload.size)
    , m_smooth(apart(workload, extent == Extent::Quick ? mostBoxPixelsWhenQuick : mostBoxPixels))
    , m_flat(flattened(m_smooth))
{
}

const Picture &PictureCheck::truth(std::size_t ruleIndex, const ContenderInfo &info)
{
    const auto key = std::tuple(ruleIndex, info.shading, info.sampleOffset);
    const auto known = m_truths.find(key);
    if (known != m_truths.end())
        return known->second;
    const TieRule &rule = tieRules[ruleIndex];
    const std::vector<Triangle> seen = seenBy(info.shading == Shading::Flat ? m_flat : m_smooth,
                                              rule, info.sampleOffset, m_size);
    return m_truths.emplace(key, truthOf(m_size, seen, rule)).first->second;
}

PictureDifference PictureCheck::check(Contender &contender)
{
    const ContenderInfo &info = contender.info();
    contender.load({m_size, info.shading == Shading::Flat ? m_flat : m_smooth});
    contender.draw();
    const Picture picture = contender.picture();
    std::optional<PictureDifference> nearest;
    for (std::size_t index = 0; index < tieRules.size(); ++index) {
        const TieRule &rule = tieRules[index];
        const bool mirrored = rule.mirrorsColumns || rule.mirrorsRows;
        if (info.exactUnder() && (mirrored || *info.exactUnder() != rule.rule))
            continue;
        const PictureDifference now = difference(picture, truth(index, info), rule);
        if (!nearest || now.coverage < nearest->coverage)
            nearest = now;
    }
    return *nearest;
}

} // namespace pixelplumb::bench
