// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/outlineties.h"

#include "core/frame/framebuffer.h"
#include "core/grade/rounding/linechoice.h"
#include "core/runs/scenerun.h"
#include "core/scan/errorlimit.h"
#include "core/scan/lines/outlinefill.h"

#include <map>

namespace pixelplumb {

namespace {

using Levels = std::array<double, 3>;

/// The least and the largest bytes of right programs; both cover the same pixels.
struct OutlinePictures {
    Picture least, most;
};

/// The lowest and the highest pixel of an outline in a column.
struct OutlineColumn {
    std::int64_t low = 0, high = 0; ///< px
    Levels ofLow = {}, ofHigh = {};
};

void add(std::map<std::int64_t, OutlineColumn> &columns, const LinePlace &place,
         const Levels &levels)
{
    const auto [found, isNew]
        = columns.try_emplace(place.x(), OutlineColumn{place.y(), place.y(), levels, levels});
    OutlineColumn &column = found->second;
    if (place.y() < column.low) {
        column.low = place.y();
        column.ofLow = levels;
    }
    if (place.y() > column.high) {
        column.high = place.y();
        column.ofHigh = levels;
    }
}

/// `stays`: the edges that do not step across at p = 0, as bits.
std::map<std::int64_t, OutlineColumn> outlineOf(const Triangle &triangle, unsigned stays)
{
    const OutlineFillSetUp setUp = outlineFillSetUp(triangle);
    std::map<std::int64_t, OutlineColumn> columns;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        BresenhamSetUp line = setUp.edges[edge].line;
        line.leastMove = (stays >> edge) & 1U;
        const auto &[from, to] = setUp.edges[edge].ends;
        BresenhamStep step = bresenhamStepAt(line, 0);
        for (std::int64_t number = 0; number <= line.deltaX; ++number) {
            const double share = line.deltaX > 0 ? double(number) / double(line.deltaX) : 0;
            add(columns, step.place, levelsBetween(setUp.corners[from], setUp.corners[to], share));
            advance(line, step);
        }
    }
    return columns;
}

/// Rounding of levels along an edge, then of those along a column.
double levelErrorOf(const Triangle &triangle, Arithmetic arithmetic)
{
    const SampleBox box = boundingBoxOf(triangle);
    const auto steps = double(box.endX - box.firstX + box.endY - box.firstY + 2);
    return arithmetic == Arithmetic::Exact ? 0 : 5 * errorLimit(arithmetic, steps, 256, 256);
}

void paint(const Triangle &triangle, unsigned stays, const Scene &scene, Arithmetic arithmetic,
           OutlinePictures &pictures)
{
    constexpr double ownError = 1e-9; // of these doubles
    const double error = levelErrorOf(triangle, arithmetic) + ownError;
    const FrameSpec &frame = scene.frame;
    for (const auto &[x, column] : outlineOf(triangle, stays)) {
        for (std::int64_t y = std::max<std::int64_t>(column.low, frame.firstRow);
             y <= std::min<std::int64_t>(column.high, frame.firstRow + frame.height - 1); ++y) {
            if (x < frame.firstColumn || x >= frame.firstColumn + frame.width)
                continue;
            const std::size_t place
                = pictures.least.placeOf(int(x - frame.firstColumn), int(pictureLine(frame, y)));
            const double share = column.high > column.low
                ? double(y - column.low) / double(column.high - column.low)
                : 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double level = column.ofLow[i] + share * (column.ofHigh[i] - column.ofLow[i]);
                const LevelRange range{level - error, level + error};
                const auto [least, most] = range.bytes(scene.settings.rounding);
                pictures.least.colours[place].channels[i] = std::uint8_t(least);
                pictures.most.colours[place].channels[i] = std::uint8_t(most);
            }
            pictures.least.covered[place] = 1;
        }
    }
}

bool hasAt(const OutlinePictures &pictures, const Picture &found, std::size_t place)
{
    if (!found.hasColours)
        return pictures.least.covered[place] == found.covered[place];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint8_t byte = found.colours[place].channels[i];
        if (byte < pictures.least.colours[place].channels[i]
            || byte > pictures.most.colours[place].channels[i])
            return false;
    }
    return true;
}

/// Outlines that reach far beyond the frame are not walked.
bool isWalked(const std::vector<Triangle> &triangles)
{
    constexpr std::int64_t mostSteps = 1'000'000;
    std::int64_t steps = 0;
    for (const Triangle &triangle : triangles) {
        const SampleBox box = boundingBoxOf(triangle);
        steps += 2 * (box.endX - box.firstX + box.endY - box.firstY);
    }
    return steps <= mostSteps;
}

} // namespace

std::vector<std::uint8_t> ofOtherOutlines(const Scene &scene, const Picture &drawn,
                                          const Picture &found, Arithmetic arithmetic)
{
    std::vector<std::uint8_t> open(found.size(), 0);
    const std::vector<Triangle> triangles = primitivesOnSamples(scene).triangles;
    if (!isWalked(triangles))
        return open;
    constexpr unsigned choices = 8; // of three edges
    for (unsigned stays = 0; stays < choices; ++stays) {
        const Picture empty = emptyPicture(scene.frame);
        OutlinePictures pictures{empty, empty};
        for (const Triangle &triangle : triangles)
            paint(triangle, stays, scene, arithmetic, pictures);
        for (std::size_t place = 0; place < open.size(); ++place) {
            const bool isDifferent = drawn.hasColours && found.hasColours
                ? drawn.colours[place] != found.colours[place]
                : drawn.covered[place] != found.covered[place];
            if (isDifferent && hasAt(pictures, found, place))
                open[place] = 1;
        }
    }
    return open;
}

} // namespace pixelplumb
