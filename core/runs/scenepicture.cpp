// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenepicture.h"

#include "core/frame/keptrows.h"
#include "core/frame/pixelrows.h"
#include "core/runs/sceneplan.h"
#include "core/scan/columndrawing.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Triangles between two questions whether to go on: some milliseconds of each.
constexpr std::size_t fastPiece = std::size_t(1) << 16;
constexpr std::size_t plainPiece = std::size_t(1) << 10;

Triangle onSamples(Triangle triangle, Lattice offset)
{
    for (Vertex &vertex : triangle.vertices)
        vertex.position = {vertex.position.x - offset, vertex.position.y - offset};
    return triangle;
}

/// Rows by which rounded increments may leave a triangle's bounding box, amply: float32 adds some
/// 2^13 columns of at most 2^12 px with errors of at most 2^-13 px each.
constexpr std::int64_t rowsOfError = 4;
constexpr Lattice largestOfSmallError = (Lattice(1) << 12) * unitsPerPixel;

/// More triangles are not kept for comparison: they take 72 bytes each.
constexpr std::size_t mostCompared = std::size_t(1) << 20;

bool staysNearItsBox(const Triangle &triangle)
{
    return std::ranges::all_of(triangle.vertices, [](const Vertex &vertex) {
        return absolute(vertex.position.x) <= largestOfSmallError
            && absolute(vertex.position.y) <= largestOfSmallError;
    });
}

/// Whether rows can be drawn by themselves: where it is known which triangles reach into them.
bool isDrawnByRows(const Scene &scene, const Method &method)
{
    const bool wraps = scene.settings.arithmetic == Arithmetic::Fixed16; // to any row
    return method.drawFast && !wraps && scene.shapes.empty() && !mayCallForEffects(scene)
        && scene.triangles.size() <= mostCompared
        && std::ranges::all_of(scene.triangles, staysNearItsBox);
}

bool differInTrianglesAlone(const Scene &scene, const Scene &other)
{
    return scene.frame == other.frame && scene.settings == other.settings
        && scene.method == other.method && scene.shapes == other.shapes
        && scene.attributes == other.attributes && scene.appearance == other.appearance
        && scene.triangles.size() == other.triangles.size();
}

/// Of two words that are not the same.
Difference differenceBetween(QRgb drawn, QRgb twin)
{
    if (qAlpha(drawn) == 0)
        return Difference::Missing;
    return qAlpha(twin) == 0 ? Difference::Extra : Difference::Colour;
}

} // namespace

ScenePicture::ScenePicture(const FrameSpec &frame)
    : m_drawn(frame)
    , m_differences(frame)
{
}

const FrameBuffer *ScenePicture::exactTwin() const
{
    switch (m_twinKind) {
    case Twin::Itself:
        return &m_drawn;
    case Twin::Drawn:
        return m_twin.get();
    case Twin::None:
        break;
    }
    return nullptr;
}

ScenePicture::Twin ScenePicture::twinOf(const Scene &scene, const Method &method)
{
    if (method.isStableIn(scene.settings.arithmetic))
        return Twin::Itself;
    const bool drawsShapes = std::ranges::any_of(
        scene.shapes, [&method](const Shape &shape) { return method.draws(shape); });
    const bool isKept = methodNamed(u"column-scan")->supports(scene.settings.fillRule);
    return method.draws(PrimitiveKind::Triangle) && isKept && !drawsShapes ? Twin::Drawn
                                                                           : Twin::None;
}

bool ScenePicture::draw(const std::shared_ptr<const Scene> &scene, const ProgressListener &listener)
{
    const Method *method = methodNamed(QString::fromStdString(scene->method));
    Q_ASSERT(method && objectionTo(*scene).isEmpty());
    Q_ASSERT(scene->frame == spec());
    const Rows rows = rowsToDraw(*scene, *method);
    m_twinKind = twinOf(*scene, *method);
    m_scene.reset();
    if (m_twinKind == Twin::Drawn && !m_twin)
        m_twin = std::make_unique<FrameBuffer>(spec());
    const bool isWhole = rows.first == allRows().first && rows.end == allRows().end;
    if (isWhole) {
        clear(rows);
        if (!drawAll(*scene, *method, listener))
            return false;
    } else if (rows.first < rows.end && !drawRows(rows, *scene, *method, listener)) {
        return false;
    }
    compareRows(rows);
    if (isDrawnByRows(*scene, *method))
        m_scene = scene;
    return true;
}

/// In sample coordinates; of all that rounding may make of it.
ScenePicture::Rows ScenePicture::rowsReachedBy(const Triangle &triangle)
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [low, high] = std::minmax({a.position.y, b.position.y, c.position.y});
    return {floorPixel(low) - rowsOfError, ceilPixel(high) + rowsOfError + 1};
}

ScenePicture::Rows ScenePicture::allRows() const
{
    return {spec().firstRow, std::int64_t(spec().firstRow) + spec().height};
}

/// Those that differ from the picture as it is.
ScenePicture::Rows ScenePicture::rowsToDraw(const Scene &scene, const Method &method) const
{
    if (!m_scene || !differInTrianglesAlone(scene, *m_scene) || !isDrawnByRows(scene, method))
        return allRows();
    Rows rows = {allRows().end, allRows().first};
    const Lattice offset = sampleOffset(scene.frame);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        if (scene.triangles[i] == m_scene->triangles[i])
            continue;
        for (const Triangle &triangle : {scene.triangles[i], m_scene->triangles[i]}) {
            const Rows reached = rowsReachedBy(onSamples(triangle, offset));
            rows = {std::min(rows.first, reached.first), std::max(rows.end, reached.end)};
        }
    }
    return {std::max(rows.first, allRows().first), std::min(rows.end, allRows().end)};
}

bool ScenePicture::drawAll(const Scene &scene, const Method &method,
                           const ProgressListener &listener)
{
    const auto count = std::int64_t(scene.triangles.size() + scene.shapes.size());
    // Triangles may depend on those before them: such a scene is drawn whole.
    if (mayCallForEffects(scene)) {
        if (!goesOn(listener, {JobPhase::Drawing, 0, 1}))
            return false;
        m_piece = primitivesOnSamples(scene);
        drawPiece(scene, method);
        return true;
    }
    const std::size_t pieceSize = method.drawFast ? fastPiece : plainPiece;
    for (std::size_t first = 0; first < scene.triangles.size(); first += pieceSize) {
        if (!goesOn(listener, {JobPhase::Drawing, std::int64_t(first), count}))
            return false;
        takePiece(scene, first, std::min(pieceSize, scene.triangles.size() - first));
        drawPiece(scene, method);
    }
    Scene rest;
    rest.frame = scene.frame;
    auto done = std::int64_t(scene.triangles.size());
    for (const Shape &shape : scene.shapes) {
        if (!goesOn(listener, {JobPhase::Drawing, done++, count}))
            return false;
        rest.shapes = {shape};
        m_piece = primitivesOnSamples(rest);
        drawPiece(scene, method);
    }
    return true;
}

/// Draws the triangles that may reach into the rows, and puts back what they paint outside: in a
/// window of these rows alone, rounded increments would begin anew at its first row.
bool ScenePicture::drawRows(Rows rows, const Scene &scene, const Method &method,
                            const ProgressListener &listener)
{
    if (!goesOn(listener, {JobPhase::Drawing, 0, 1}))
        return false;
    takePiece(scene, 0, 0); // empties it and keeps its memory
    const Lattice offset = sampleOffset(scene.frame);
    Rows painted = rows;
    for (const Triangle &each : scene.triangles) {
        const Triangle triangle = onSamples(each, offset);
        const Rows reached = rowsReachedBy(triangle);
        if (reached.end <= rows.first || reached.first >= rows.end)
            continue;
        painted = {std::min(painted.first, reached.first), std::max(painted.end, reached.end)};
        m_piece.triangles.push_back(triangle);
    }
    painted = {std::max(painted.first, allRows().first), std::min(painted.end, allRows().end)};
    std::vector<KeptRows> kept;
    for (const FrameBuffer *frame : frames()) {
        kept.emplace_back(rowsOf(frame->view(), painted.first, rows.first));
        kept.emplace_back(rowsOf(frame->view(), rows.end, painted.end));
    }
    clear(rows);
    drawPiece(scene, method);
    for (const KeptRows &each : kept)
        each.putBack();
    return true;
}

void ScenePicture::drawPiece(const Scene &scene, const Method &method)
{
    method.drawFastest(m_piece, scene.settings, m_drawn.view());
    if (m_twinKind != Twin::Drawn)
        return;
    const ScanSettings exact{Arithmetic::Exact, scene.settings.fillRule, scene.settings.rounding};
    methodNamed(u"column-scan")->drawFastest(m_piece, exact, m_twin->view());
}

/// Those that are drawn into.
std::vector<const FrameBuffer *> ScenePicture::frames() const
{
    std::vector<const FrameBuffer *> frames = {&m_drawn};
    if (m_twinKind == Twin::Drawn)
        frames.push_back(m_twin.get());
    return frames;
}

void ScenePicture::clear(Rows rows)
{
    for (const FrameBuffer *frame : frames())
        fillTransparent(rowsOf(frame->view(), rows.first, rows.end), spec().background);
}

void ScenePicture::takePiece(const Scene &scene, std::size_t first, std::size_t count)
{
    const auto begin = scene.triangles.begin() + std::ptrdiff_t(first);
    m_piece.triangles.assign(begin, begin + std::ptrdiff_t(count));
    m_piece.shapes.clear();
    if (const Lattice offset = sampleOffset(scene.frame); offset != 0) {
        for (Triangle &triangle : m_piece.triangles)
            triangle = onSamples(triangle, offset);
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
void ScenePicture::compareRows(Rows rows)
{
    const FrameView drawn = m_drawn.view();
    for (std::int64_t y = rows.first; y < rows.end; ++y) {
        forgetDifferences(y);
        QRgb *const drawnRow = drawn.at(drawn.firstColumn, y);
        if (m_twinKind == Twin::Drawn) {
            QRgb *const twinRow = m_twin->view().at(drawn.firstColumn, y);
            if (!areSame(drawnRow, twinRow, drawn.width))
                noteDifferences(y, drawnRow, twinRow);
            makeOpaque(twinRow, drawn.width);
        }
        makeOpaque(drawnRow, drawn.width);
    }
}

void ScenePicture::forgetDifferences(std::int64_t y)
{
    if (m_differences.total() == 0)
        return;
    const std::span<const Difference> row = m_differences.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
        if (row[x] != Difference::None)
            m_differences.set(spec().firstColumn + std::int64_t(x), y, Difference::None);
    }
}

void ScenePicture::noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *twinRow)
{
    for (std::int32_t x = 0; x < spec().width; ++x) {
        if (drawnRow[x] != twinRow[x])
            m_differences.set(std::int64_t(spec().firstColumn) + x, y,
                              differenceBetween(drawnRow[x], twinRow[x]));
    }
}

} // namespace pixelplumb
