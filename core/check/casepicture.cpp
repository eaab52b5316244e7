// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casepicture.h"

#include <QCryptographicHash>

namespace pixelplumb {

namespace {

FrameSpec mirrored(FrameSpec canvas)
{
    canvas.firstRow = -(canvas.firstRow + canvas.height - 1);
    return canvas;
}

} // namespace

void drawTruly(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    Run(nullptr, primitives, settings, frame).drawTruth(frame);
}

Drawing drawingBy(const Method &method, Kernels kernels)
{
    return [&method, kernels](const Primitives &primitives, const ScanSettings &settings,
                              FrameView frame) {
        Run(&method, primitives, settings, frame, kernels).draw(frame);
    };
}

CasePicture::CasePicture(const FrameSpec &canvas, FillRule rule)
    : m_canvas(canvas)
    , m_sign(rule == FillRule::TopLeft ? -1 : 1)
    , m_frame(rule == FillRule::TopLeft ? mirrored(canvas) : canvas)
{
}

void CasePicture::draw(const Primitives &primitives, const ScanSettings &settings,
                       const Drawing &drawing)
{
    Primitives drawn = primitives;
    for (Triangle &triangle : drawn.triangles) {
        for (Vertex &vertex : triangle.vertices)
            vertex.position.y *= m_sign;
    }
    for (Shape &shape : drawn.shapes) {
        for (Vertex &vertex : shape.vertices)
            vertex.position.y *= m_sign;
    }
    drawing(drawn, settings, m_frame.view());
}

void CasePicture::draw(const Triangle &triangle, const ScanSettings &settings,
                       const Drawing &drawing)
{
    draw(Primitives{{triangle}, {}}, settings, drawing);
}

std::int64_t CasePicture::pixelCount() const
{
    std::int64_t count = 0;
    forEachWritten([&](std::int64_t, std::int64_t) { ++count; });
    return count;
}

std::array<std::int64_t, 3> CasePicture::channelSums() const
{
    std::array<std::int64_t, 3> sums = {};
    forEachWritten([&](std::int64_t x, std::int64_t y) {
        const Colour colour = colourAt(x, y);
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += colour.channels[channel];
    });
    return sums;
}

QByteArray CasePicture::spanHash() const
{
    struct Span {
        std::int64_t x = 0, lowest = 0, highest = 0;
    };
    std::vector<Span> spans;
    forEachWritten([&](std::int64_t x, std::int64_t y) {
        if (spans.empty() || spans.back().x != x)
            spans.push_back({x, y, y});
        spans.back().highest = y;
    });
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const Span &span : spans) {
        hash.addData(QByteArray::number(qint64(span.x)) + ' '
                     + QByteArray::number(qint64(span.lowest)) + ' '
                     + QByteArray::number(qint64(span.highest)) + '\n');
    }
    return hash.result().toHex().first(16);
}

QByteArray CasePicture::pixelHash() const
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    forEachWritten([&](std::int64_t x, std::int64_t y) {
        hash.addData(QByteArray::number(qint64(x)) + ' ' + QByteArray::number(qint64(y)) + '\n');
    });
    return hash.result().toHex().first(16);
}

QByteArray CasePicture::colourHash() const
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    forEachWritten([&](std::int64_t x, std::int64_t y) {
        const Colour colour = colourAt(x, y);
        QByteArray line = QByteArray::number(qint64(x)) + ' ' + QByteArray::number(qint64(y));
        for (const std::uint8_t level : colour.channels)
            line += ' ' + QByteArray::number(level);
        hash.addData(line + '\n');
    });
    return hash.result().toHex().first(16);
}

DifferenceCounts differencesBetween(const CasePicture &drawn, const CasePicture &truth)
{
    DifferenceCounts counts;
    drawn.forEachWritten([&](std::int64_t x, std::int64_t y) {
        const bool isWanted = truth.isWritten(x, y);
        if (!isWanted || drawn.colourAt(x, y) != truth.colourAt(x, y))
            counts.add(differenceOf(true, isWanted));
    });
    truth.forEachWritten([&](std::int64_t x, std::int64_t y) {
        if (!drawn.isWritten(x, y))
            counts.add(Difference::Missing);
    });
    return counts;
}

} // namespace pixelplumb
