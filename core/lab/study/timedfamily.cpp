// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/timedfamily.h"

#include "core/frame/writtenframe.h"
#include "core/lab/judging/pixelwindow.h"
#include "core/measure/writecount.h"
#include "core/methods/method.h"

#include <QCryptographicHash>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int64_t fewestTimed = 3; ///< triangles, where a family has them
/// Samples of a picture that is one of many: a larger one would take most of the time.
constexpr std::int64_t largestOfMany = 256 * 256;
constexpr std::int64_t cacheLineBytes = 64;

std::int64_t samplesOf(const LabPicture &picture)
{
    return std::int64_t(picture.frame.width) * picture.frame.height;
}

std::int64_t pixelsIn(const SampleBox &box)
{
    return box.isEmpty() ? 0 : (box.endX - box.firstX) * (box.endY - box.firstY);
}

/// The triangle's area in px, at most its box within the frame.
std::int64_t aboutPixels(const Triangle &triangle, const SampleBox &box)
{
    const auto area
        = std::int64_t(absolute(doubledArea(triangle)) / (2 * unitsPerPixel * unitsPerPixel));
    return std::min(area, pixelsIn(box));
}

/// The bytes of the cache lines that a picture writes to.
std::int64_t bytesOfLines(const FrameView &frame)
{
    constexpr auto perLine = cacheLineBytes / std::int64_t(sizeof(QRgb));
    std::int64_t lines = 0;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        const QRgb *const row = frame.at(frame.firstColumn, y);
        for (std::int64_t x = 0; x < frame.width; x += perLine) {
            const auto end = std::min<std::int64_t>(x + perLine, frame.width);
            lines += std::any_of(row + x, row + end, [](QRgb pixel) { return pixel != 0; }) ? 1 : 0;
        }
    }
    return lines * cacheLineBytes;
}

/// Adds what a picture's first triangles write.
void addWrites(StudyFamily &described, const TimedPicture &timed, FillRule rule)
{
    const Method &scan = *methodNamed(u"column-scan");
    const ScanSettings exact = scan.adapted({Arithmetic::Exact, rule, ByteRounding::Nearest});
    FrameSpec black = timed.picture->frame;
    black.background = {};
    described.timedPixels
        += std::int64_t(countWrites(timed.first(), exact.fillRule, black, {}).value_or(0));
    std::vector<Triangle> white(timed.first().begin(), timed.first().end());
    for (Triangle &triangle : white) {
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = {{255, 255, 255}};
    }
    const WrittenFrame frame(black);
    Run(&scan, {white, {}}, exact, frame.view()).draw(frame.view());
    described.timedBytes += bytesOfLines(frame.view());
}

QString digestOf(const LabFamily &family)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add
        = [&hash](std::int64_t value) { hash.addData(QByteArray::number(qint64(value)) + ' '); };
    add(int(family.settings.fillRule));
    add(int(family.settings.rounding));
    for (const LabPicture &picture : family.pictures) {
        const FrameSpec &frame = picture.frame;
        for (const std::int64_t value :
             {frame.width, frame.height, frame.firstColumn, frame.firstRow})
            add(value);
        add(int(frame.origin));
        for (const Triangle &triangle : picture.triangles) {
            for (const Vertex &vertex : triangle.vertices) {
                add(vertex.position.x);
                add(vertex.position.y);
                for (const int level : vertex.colour.channels)
                    add(level);
            }
        }
    }
    return QString::fromLatin1(hash.result().toHex().left(16));
}

/// Takes triangles up to the limits.
class TimedTriangles {
public:
    TimedTriangles(StudyFamily &described, const TimedLimits &limits)
        : m_described(described)
        , m_limits(limits)
    {
    }

    TimedPicture firstOf(const LabPicture &picture)
    {
        const FrameBuffer frame(picture.frame);
        TimedPicture timed{&picture, 0};
        for (const Triangle &triangle : picture.triangles) {
            if (areEnough())
                break;
            ++timed.triangles;
            add(triangle, windowAround(triangle, 0, frame.view()));
        }
        return timed;
    }

private:
    bool areEnough() const
    {
        return m_described.timedTriangles >= fewestTimed
            && (m_pixels > m_limits.pixels || m_boxPixels > m_limits.boxPixels);
    }

    void add(const Triangle &triangle, const SampleBox &box)
    {
        ++m_described.timedTriangles;
        m_pixels += aboutPixels(triangle, box);
        m_boxPixels += pixelsIn(box);
        m_described.timedColumns += std::max<std::int64_t>(0, box.endX - box.firstX);
        m_described.timedRows += std::max<std::int64_t>(0, box.endY - box.firstY);
    }

    StudyFamily &m_described;
    TimedLimits m_limits;
    std::int64_t m_pixels = 0;
    std::int64_t m_boxPixels = 0;
};

} // namespace

TimedFamily timedPartOf(const LabFamily &family, const TimedLimits &limits)
{
    TimedFamily part;
    part.family = &family;
    part.described.id = family.id;
    part.described.title = family.title;
    if (const LabFamilyInfo *info = labFamilyNamed(family.id))
        part.described.stresses = QString::fromUtf8(info->stresses);
    part.described.triangles = std::int64_t(family.triangleCount());
    part.described.digest = digestOf(family);
    TimedTriangles triangles(part.described, limits);
    for (const LabPicture &picture : family.pictures) {
        if (family.pictures.size() > 1 && samplesOf(picture) > largestOfMany)
            continue;
        const TimedPicture timed = triangles.firstOf(picture);
        if (timed.triangles == 0)
            continue;
        addWrites(part.described, timed, family.settings.fillRule);
        part.pictures.push_back(timed);
    }
    return part;
}

} // namespace pixelplumb
