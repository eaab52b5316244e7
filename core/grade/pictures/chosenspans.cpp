// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/chosenspans.h"

#include "core/frame/framebuffer.h"

namespace pixelplumb {

namespace {

/// How many pixels each span of the frame has: columns have the picture's lines, rows its columns.
int lengthOf(const ChosenSpans &chosen, const FrameSpec &frame)
{
    return chosen.areColumns() ? frame.height : frame.width;
}

/// Where the i-th pixel of the span at that place is in the picture of chosen spans.
std::size_t indexIn(const ChosenSpans &chosen, const FrameSpec &frame, std::size_t place, int i)
{
    return chosen.areColumns() ? std::size_t(i) * chosen.spans().size() + place
                               : place * std::size_t(frame.width) + std::size_t(i);
}

void setPixel(Picture &to, std::size_t index, const Picture &from, std::size_t place)
{
    to.colours[index] = from.colours[place];
    to.covered[index] = from.covered[place];
}

} // namespace

ChosenSpans::ChosenSpans(SpanAxis axis, std::vector<std::int64_t> spans)
    : m_axis(axis)
    , m_spans(std::move(spans))
    , m_places(std::size_t(m_spans.back() - m_spans.front()) + 1, notChosen)
{
    for (std::size_t place = 0; place < m_spans.size(); ++place)
        m_places[std::size_t(m_spans[place] - m_spans.front())] = std::uint32_t(place);
}

FrameSpec partOf(const FrameSpec &frame, SpanAxis axis, std::int64_t span)
{
    FrameSpec part = frame;
    const LatticePoint point = offScreenSample(frame);
    const Lattice offset = sampleOffset(frame);
    part.offScreenPoint = LatticePoint{point.x + offset, point.y + offset};
    if (axis == SpanAxis::Column) {
        part.firstColumn = std::int32_t(span);
        part.width = 1;
    } else {
        part.firstRow = std::int32_t(span);
        part.height = 1;
    }
    return part;
}

Picture emptyPicture(const FrameSpec &frame, const ChosenSpans &chosen)
{
    FrameSpec part = frame;
    (chosen.areColumns() ? part.width : part.height) = std::int32_t(chosen.spans().size());
    return emptyPicture(part);
}

void forEachPlace(const ChosenSpans &chosen, const FrameSpec &frame,
                  const std::function<void(int x, int line, std::size_t place)> &visit)
{
    for (std::size_t place = 0; place < chosen.spans().size(); ++place) {
        const std::int64_t span = chosen.spans()[place];
        const int along
            = chosen.areColumns() ? int(span - frame.firstColumn) : pictureLine(frame, span);
        for (int i = 0; i < lengthOf(chosen, frame); ++i)
            visit(chosen.areColumns() ? along : i, chosen.areColumns() ? i : along,
                  indexIn(chosen, frame, place, i));
    }
}

Picture partOf(const Picture &picture, const FrameSpec &frame, const ChosenSpans &chosen)
{
    Picture part = emptyPicture(frame, chosen);
    part.hasColours = picture.hasColours;
    forEachPlace(chosen, frame, [&](int x, int line, std::size_t place) {
        setPixel(part, place, picture, picture.placeOf(x, line));
    });
    return part;
}

void copyTo(Picture &picture, const FrameSpec &frame, const ChosenSpans &chosen,
            const Picture &part)
{
    forEachPlace(chosen, frame, [&](int x, int line, std::size_t place) {
        setPixel(picture, picture.placeOf(x, line), part, place);
    });
}

Picture pictureOf(const Scene &scene, const ChosenSpans &chosen)
{
    Picture picture = emptyPicture(scene.frame, chosen);
    Scene part = scene;
    for (std::size_t place = 0; place < chosen.spans().size(); ++place) {
        part.frame = partOf(scene.frame, chosen.axis(), chosen.spans()[place]);
        const Picture drawn = pictureOf(part);
        for (std::size_t i = 0; i < drawn.size(); ++i)
            setPixel(picture, indexIn(chosen, scene.frame, place, int(i)), drawn, i);
    }
    return picture;
}

} // namespace pixelplumb
