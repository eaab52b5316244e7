// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/picturediff.h"

#include "core/frame/framebuffer.h"
#include "core/grade/pictures/picturecause.h"
#include "core/oracle/oracle.h"
#include "core/scan/tests/edgeteststate.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace pixelplumb {

namespace {

int errorBetween(const Colour &a, const Colour &b)
{
    int error = 0;
    for (std::size_t i = 0; i < 3; ++i)
        error = std::max(error, std::abs(int(a.channels[i]) - int(b.channels[i])));
    return error;
}

Difference verdictAt(const Picture &expected, const Picture &found, std::size_t place)
{
    // Drawing in the background's colour is invisible: where there are bytes, they decide.
    const bool haveColours = expected.hasColours && found.hasColours;
    if (haveColours && expected.colours[place] == found.colours[place])
        return Difference::None;
    const Difference difference
        = differenceOf(found.covered[place] != 0, expected.covered[place] != 0);
    return difference == Difference::Colour && !haveColours ? Difference::None : difference;
}

void findCauses(const Picture &expected, const Picture &found, PictureDiff &diff)
{
    const std::int64_t before = differingPixels(expected, found);
    const Colour background = backgroundOf(expected);
    std::vector<PictureChange> changes = pictureChangesFor(expected, background);
    if (expected.hasColours) {
        if (const auto other = otherBackgroundIn(found, expected, background))
            changes.push_back(drawnOn(*other, nameOf(background)));
    }
    for (const PictureChange &change : changes) {
        const std::int64_t left
            = differingPixels(changed(expected, change.pixel, background), found);
        if (2 * left <= before)
            diff.causes.push_back({change.name, left});
    }
    std::ranges::stable_sort(diff.causes, {}, &PictureCause::left);
}

/// Compares in blocks, most of which are equal: thousands of pictures are compared with one.
template <class Entry>
std::int64_t differingEntries(const std::vector<Entry> &expected, const std::vector<Entry> &found,
                              std::int64_t limit)
{
    static_assert(std::has_unique_object_representations_v<Entry>);
    constexpr std::size_t block = 32;
    std::int64_t differing = 0;
    for (std::size_t first = 0; first < expected.size() && differing < limit; first += block) {
        const std::size_t end = std::min(first + block, expected.size());
        if (std::memcmp(&expected[first], &found[first], (end - first) * sizeof(Entry)) == 0)
            continue;
        for (std::size_t i = first; i < end && differing < limit; ++i)
            differing += int(expected[i] != found[i]);
    }
    return differing;
}

} // namespace

std::int64_t differingPixels(const Picture &expected, const Picture &found, std::int64_t limit)
{
    if (expected.hasColours && found.hasColours)
        return differingEntries(expected.colours, found.colours, limit);
    return differingEntries(expected.covered, found.covered, limit);
}

PictureDiff differenceOf(const Picture &expected, const Picture &found,
                         std::span<const std::uint8_t> undecidable)
{
    PictureDiff diff;
    diff.width = expected.width;
    diff.height = expected.height;
    diff.verdicts.reserve(expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        Difference verdict = verdictAt(expected, found, i);
        const bool isOpen = !undecidable.empty() && undecidable[i] != 0;
        if (verdict != Difference::None && isOpen)
            verdict = Difference::Undecidable;
        if (verdict == Difference::Colour)
            diff.largestError
                = std::max(diff.largestError, errorBetween(expected.colours[i], found.colours[i]));
        diff.verdicts.push_back(verdict);
        diff.counts.add(verdict);
    }
    if (diff.differing() > 0)
        findCauses(expected, found, diff);
    return diff;
}

std::vector<std::uint8_t> tiesOf(const Scene &scene)
{
    const FrameSpec &frame = scene.frame;
    const FrameView window = windowOf(frame);
    std::vector<std::uint8_t> ties(std::size_t(frame.width) * std::size_t(frame.height), 0);
    for (const Triangle &triangle : primitivesOnSamples(scene).triangles) {
        const SampleBox box = intersection(boundingBoxOf(triangle), samplesOf(window));
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                if (oracle::covers(triangle, FillRule::Closed, x, y)
                    != oracle::covers(triangle, FillRule::Open, x, y))
                    ties[std::size_t(std::int64_t(pictureLine(frame, y)) * frame.width + x
                                     - frame.firstColumn)]
                        = 1;
            }
        }
    }
    return ties;
}

std::optional<QRgb> markOf(Difference verdict)
{
    switch (verdict) {
    case Difference::None:
        break;
    case Difference::Missing:
        return qRgb(213, 94, 0);
    case Difference::Extra:
        return qRgb(0, 114, 178);
    case Difference::Colour:
        return qRgb(204, 121, 167);
    case Difference::Undecidable:
        return qRgb(240, 228, 66);
    }
    return std::nullopt;
}

QString rasterOf(const PictureDiff &diff, const Picture &expected)
{
    QString raster;
    for (int line = 0; line < diff.height; ++line) {
        for (int x = 0; x < diff.width; ++x) {
            const std::size_t place = expected.placeOf(x, line);
            switch (diff.verdicts[place]) {
            case Difference::None:
                raster += expected.covered[place] != 0 ? u'#' : u'.';
                break;
            case Difference::Missing:
                raster += u'?';
                break;
            case Difference::Extra:
                raster += u'!';
                break;
            case Difference::Colour:
                raster += u'c';
                break;
            case Difference::Undecidable:
                raster += u'=';
                break;
            }
        }
        raster += u'\n';
    }
    return raster;
}

} // namespace pixelplumb
