// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/scenepicture.h"

#include "core/fast/fastscan.h"
#include "core/methods/columnscan.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QRgb opaque = 0xff000000;

// Triangles between two questions whether to go on: some milliseconds of each.
constexpr std::size_t fastPiece = std::size_t(1) << 16;
constexpr std::size_t plainPiece = std::size_t(1) << 10;

/// Fills a frame with its background, transparent: kernels write opaque pixels, so that what is
/// opaque afterwards was written, even in the colour of the background.
void clearTransparent(const FrameBuffer &frame)
{
    const FrameView view = frame.view();
    const QRgb untouched = packed(frame.spec().background) & ~opaque;
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y)
        std::fill_n(view.at(view.firstColumn, y), view.width, untouched);
}

// Loops without branches, which compilers turn into vectors.

bool areSame(const QRgb *left, const QRgb *right, std::int32_t count)
{
    QRgb different = 0;
    for (std::int32_t x = 0; x < count; ++x)
        different |= left[x] ^ right[x];
    return different == 0;
}

void makeOpaque(QRgb *pixels, std::int32_t count)
{
    for (std::int32_t x = 0; x < count; ++x)
        pixels[x] |= opaque;
}

/// Of two words that are not the same.
Difference differenceBetween(QRgb drawn, QRgb truth)
{
    if (qAlpha(drawn) == 0)
        return Difference::Missing;
    return qAlpha(truth) == 0 ? Difference::Extra : Difference::Colour;
}

} // namespace

ScenePicture::ScenePicture(const FrameSpec &frame)
    : m_drawn(frame)
    , m_differences(frame)
{
}

const FrameBuffer *ScenePicture::truth() const
{
    switch (m_truthKind) {
    case Truth::Drawn:
        return &m_drawn;
    case Truth::Compared:
        return m_truth.get();
    case Truth::Unknown:
        break;
    }
    return nullptr;
}

ScenePicture::Truth ScenePicture::truthOf(const Scene &scene, const Method &method)
{
    if (method.isStableIn(scene.settings.arithmetic))
        return Truth::Drawn;
    const bool drawsShapes = std::ranges::any_of(
        scene.shapes, [&method](const Shape &shape) { return method.draws(shape); });
    const bool isKept = scene.settings.fillRule == FillRule::Closed
        || scene.settings.fillRule == FillRule::HalfOpenColumn;
    return method.draws(PrimitiveKind::Triangle) && isKept && !drawsShapes ? Truth::Compared
                                                                           : Truth::Unknown;
}

bool ScenePicture::draw(const Scene &scene, const GoesOn &goesOn)
{
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    Q_ASSERT(method && method->refusal(scene.settings).isEmpty());
    Q_ASSERT(scene.frame == spec());
    m_truthKind = truthOf(scene, *method);
    m_differences.clear();
    clearTransparent(m_drawn);
    if (m_truthKind == Truth::Compared) {
        if (!m_truth)
            m_truth = std::make_unique<FrameBuffer>(spec());
        clearTransparent(*m_truth);
    }
    if (!drawPieces(scene, *method, goesOn))
        return false;
    compareRows();
    return true;
}

bool ScenePicture::drawPieces(const Scene &scene, const Method &method, const GoesOn &goesOn)
{
    const std::size_t pieceSize = method.drawFast ? fastPiece : plainPiece;
    for (std::size_t first = 0; first < scene.triangles.size(); first += pieceSize) {
        if (!goesOn())
            return false;
        takePiece(scene, first, std::min(pieceSize, scene.triangles.size() - first));
        drawPiece(scene, method);
    }
    Scene rest;
    rest.frame = scene.frame;
    for (const Shape &shape : scene.shapes) {
        if (!goesOn())
            return false;
        rest.shapes = {shape};
        m_piece = primitivesOnSamples(rest);
        drawPiece(scene, method);
    }
    return true;
}

void ScenePicture::drawPiece(const Scene &scene, const Method &method)
{
    const auto draw = method.drawFast ? method.drawFast : method.draw;
    draw(m_piece, scene.settings, m_drawn.view());
    if (m_truthKind != Truth::Compared)
        return;
    const ScanSettings exact{Arithmetic::Exact, scene.settings.fillRule, scene.settings.rounding};
    drawFast(m_piece.triangles, exact, m_truth->view());
}

void ScenePicture::takePiece(const Scene &scene, std::size_t first, std::size_t count)
{
    const auto begin = scene.triangles.begin() + std::ptrdiff_t(first);
    m_piece.triangles.assign(begin, begin + std::ptrdiff_t(count));
    m_piece.shapes.clear();
    if (const Lattice offset = sampleOffset(scene.frame); offset != 0) {
        for (Triangle &triangle : m_piece.triangles) {
            for (Vertex &vertex : triangle.vertices)
                vertex.position = {vertex.position.x - offset, vertex.position.y - offset};
        }
    }
    const auto isBefore = [](const TriangleAttributes &attributes, std::size_t triangle) {
        return attributes.triangle < triangle;
    };
    m_piece.attributes.assign(
        std::lower_bound(scene.attributes.begin(), scene.attributes.end(), first, isBefore),
        std::lower_bound(scene.attributes.begin(), scene.attributes.end(), first + count,
                         isBefore));
    for (TriangleAttributes &attributes : m_piece.attributes)
        attributes.triangle -= first;
}

/// Notes what differs and makes the background opaque, in one walk over the frames.
void ScenePicture::compareRows()
{
    const FrameView drawn = m_drawn.view();
    for (std::int64_t y = drawn.firstRow; y < drawn.endRow(); ++y) {
        QRgb *const drawnRow = drawn.at(drawn.firstColumn, y);
        if (m_truthKind == Truth::Compared) {
            QRgb *const trueRow = m_truth->view().at(drawn.firstColumn, y);
            if (!areSame(drawnRow, trueRow, drawn.width))
                noteDifferences(y, drawnRow, trueRow);
            makeOpaque(trueRow, drawn.width);
        }
        makeOpaque(drawnRow, drawn.width);
    }
}

void ScenePicture::noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *trueRow)
{
    for (std::int32_t x = 0; x < spec().width; ++x) {
        if (drawnRow[x] != trueRow[x])
            m_differences.set(std::int64_t(spec().firstColumn) + x, y,
                              differenceBetween(drawnRow[x], trueRow[x]));
    }
}

} // namespace pixelplumb
