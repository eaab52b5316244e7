// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/picturejudge.h"

#include "core/lab/judging/missdistance.h"
#include "core/oracle/oracle.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace pixelplumb {

namespace {

/// Adds a pixel that both painted, in different bytes.
void addWrongBytes(AccuracyFigures &figures, QRgb drawn, QRgb wanted)
{
    ++figures.wrongBytes;
    const int off
        = std::max({std::abs(qRed(drawn) - qRed(wanted)), std::abs(qGreen(drawn) - qGreen(wanted)),
                    std::abs(qBlue(drawn) - qBlue(wanted))});
    figures.largestByteError = std::max(figures.largestByteError, off);
}

} // namespace

TruePicture::TruePicture(const Triangle &of, const BoundaryRule &rule, ByteRounding rounding,
                         const FrameView &frame)
    : triangle(&of)
    , window(windowAround(of, 3, frame), frame)
{
    if (window.isEmpty())
        return;
    oracle::draw(of, rule, rounding, window.view());
    pixels = std::int64_t(window.pixels().size())
        - std::int64_t(std::ranges::count(window.pixels(), QRgb(0)));
}

void PictureJudge::judge(const TruePicture &truth, const FrameView &drawn, const SampleBox &box)
{
    ++m_figures.triangles;
    m_figures.pixels += truth.pixels;
    const std::int64_t wrongBefore = m_figures.wrongPixels();
    const FrameView wanted = truth.window.view();
    const auto length = std::size_t(std::max<std::int64_t>(0, box.endX - box.firstX));
    const std::vector<QRgb> nothing(length, 0);
    std::vector<QRgb> widened;
    for (std::int64_t y = box.firstY; y < box.endY && length > 0; ++y) {
        const QRgb *const row = drawn.at(box.firstX, y);
        const QRgb *right = nothing.data();
        if (wanted.height > 0 && y >= wanted.firstRow && y < wanted.endRow()) {
            right = wanted.at(wanted.firstColumn, y);
            if (std::size_t(wanted.width) != length) {
                widened.assign(length, 0);
                std::copy_n(right, wanted.width,
                            widened.begin() + (wanted.firstColumn - box.firstX));
                right = widened.data();
            }
        }
        if (std::memcmp(row, right, length * sizeof(QRgb)) == 0)
            continue;
        for (std::size_t i = 0; i < length; ++i) {
            if (row[i] == right[i])
                continue;
            const std::int64_t x = box.firstX + std::int64_t(i);
            noteFirst(truth, x, y);
            if (row[i] == 0)
                noteMissing(truth, x, y);
            else if (right[i] == 0)
                noteExtra(truth, x, y);
            else
                addWrongBytes(m_figures, row[i], right[i]);
        }
    }
    if (m_figures.wrongPixels() > wrongBefore)
        ++m_figures.wrongTriangles;
}

void PictureJudge::noteMissing(const TruePicture &truth, std::int64_t x, std::int64_t y)
{
    const double distance = distanceToBoundary(*truth.triangle, x, y);
    if (distance == 0) {
        ++m_figures.tiesMissing;
        return;
    }
    ++m_figures.missing;
    ++m_figures.misses.missing[MissHistogram::binOf(distance)];
    m_figures.farthestMissing = std::max(m_figures.farthestMissing, distance);
}

void PictureJudge::noteExtra(const TruePicture &truth, std::int64_t x, std::int64_t y)
{
    const double distance = distanceToBoundary(*truth.triangle, x, y);
    if (distance == 0) {
        ++m_figures.tiesExtra;
        return;
    }
    ++m_figures.extra;
    ++m_figures.misses.extra[MissHistogram::binOf(distance)];
    m_figures.farthestExtra = std::max(m_figures.farthestExtra, distance);
}

void PictureJudge::noteFirst(const TruePicture &truth, std::int64_t x, std::int64_t y)
{
    if (!m_firstMiss)
        m_firstMiss = FirstMiss{*truth.triangle, x, y};
}

AccuracyFigures figuresOfPicture(const FrameView &truth, const FrameView &drawn)
{
    AccuracyFigures figures;
    for (std::int64_t y = drawn.firstRow; y < drawn.endRow(); ++y) {
        for (std::int64_t x = drawn.firstColumn; x < drawn.endColumn(); ++x) {
            const QRgb used = *drawn.at(x, y), wanted = *truth.at(x, y);
            figures.pixels += wanted != 0 ? 1 : 0;
            if (used == wanted)
                continue;
            if (used == 0)
                ++figures.missing;
            else if (wanted == 0)
                ++figures.extra;
            else
                addWrongBytes(figures, used, wanted);
        }
    }
    return figures;
}

} // namespace pixelplumb
