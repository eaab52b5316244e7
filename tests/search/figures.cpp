// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/recipe.h"

namespace pixelplumb::search {

namespace {

constexpr std::int32_t edgeWindowSide = 64;
constexpr std::int64_t largestSide = 20000; ///< px, of a canvas that shows a whole figure
constexpr std::int64_t largestArea = 400000; ///< px, so that a search ends
constexpr int slideFrames = 24;

using Corners = std::array<LatticePoint, 3>;

std::vector<Corners> gridCorners(const std::vector<LatticePoint> &points)
{
    std::vector<Corners> corners;
    for (std::size_t row = 0; row + 1 < gridSide; ++row) {
        for (std::size_t column = 0; column + 1 < gridSide; ++column) {
            const std::size_t low = row * gridSide + column;
            const std::size_t high = low + gridSide;
            corners.push_back({points[low], points[low + 1], points[high + 1]});
            corners.push_back({points[low], points[high + 1], points[high]});
        }
    }
    return corners;
}

/// The figure's triangles, in 1/scale px.
std::vector<Corners> cornersOf(Figure figure, const std::vector<LatticePoint> &points)
{
    std::vector<Corners> corners;
    switch (figure) {
    case Figure::Triangle:
    case Figure::Moved:
        return {{points[0], points[1], points[2]}};
    case Figure::Fan:
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            corners.push_back({points[0], points[i], points[i + 1]});
        return corners;
    case Figure::Strip:
        for (std::size_t i = 0; i + 2 < points.size(); ++i)
            corners.push_back(
                {points[i], points[i + (i % 2 == 0 ? 2 : 1)], points[i + (i % 2 == 0 ? 1 : 2)]});
        for (Corners &each : corners) {
            if (doubledArea(each[0], each[1], each[2]) < 0)
                std::swap(each[1], each[2]);
        }
        return corners;
    case Figure::Grid:
        return gridCorners(points);
    case Figure::TJunction: {
        // From points[0], five steps of points[1]/5; the middle vertex after two of them.
        const LatticePoint step = {points[1].x / 5, points[1].y / 5};
        const LatticePoint first = points[0];
        const LatticePoint middle = {first.x + 2 * step.x, first.y + 2 * step.y};
        const LatticePoint last = {first.x + 5 * step.x, first.y + 5 * step.y};
        const LatticePoint one = points[2];
        const LatticePoint other = points[3];
        corners = {{first, last, one}, {last, middle, other}, {middle, first, other}};
        if (doubledArea(first, last, one) < 0) {
            for (Corners &each : corners)
                std::swap(each[1], each[2]);
        }
        return corners;
    }
    case Figure::Slide:
        for (Lattice frame = 0; frame < slideFrames; ++frame) {
            Corners moved = {points[0], points[1], points[2]};
            for (LatticePoint &point : moved)
                point = {point.x + 2 * frame, point.y + frame};
            corners.push_back(moved);
        }
        return corners;
    }
    return corners;
}

HardCaseKind kindOf(Figure figure)
{
    switch (figure) {
    case Figure::Triangle:
        return HardCaseKind::Triangle;
    case Figure::Slide:
        return HardCaseKind::Sequence;
    case Figure::Moved:
        return HardCaseKind::Translation;
    case Figure::Fan:
    case Figure::Strip:
    case Figure::Grid:
    case Figure::TJunction:
        break;
    }
    return HardCaseKind::Mesh;
}

bool isWithinFrameRange(std::int64_t pixel) { return absolute(pixel) <= largestPixel; }

/// Places the canvas around all triangles, or as a square on the first edge; false if it is too
/// large.
bool placeCanvas(const Recipe &recipe, const Genes &genes, HardCase &hardCase)
{
    LatticePoint low = hardCase.triangles.front().vertices[0].position;
    LatticePoint high = low;
    for (const Triangle &triangle : hardCase.triangles) {
        for (const Vertex &vertex : triangle.vertices) {
            low = {std::min(low.x, vertex.position.x), std::min(low.y, vertex.position.y)};
            high = {std::max(high.x, vertex.position.x), std::max(high.y, vertex.position.y)};
        }
    }
    std::int64_t firstColumn = floorPixel(low.x);
    std::int64_t firstRow = floorPixel(low.y);
    std::int64_t width = ceilPixel(high.x) - firstColumn + 1;
    std::int64_t height = ceilPixel(high.y) - firstRow + 1;
    if (recipe.window == Window::OnSample) {
        firstColumn = genes.sample.x - edgeWindowSide / 2;
        firstRow = genes.sample.y - edgeWindowSide / 2;
        width = edgeWindowSide;
        height = edgeWindowSide;
    } else if (recipe.window == Window::OnEdge) {
        const auto &v = hardCase.triangles.front().vertices;
        const LatticePoint a = v[0].position;
        const LatticePoint b = v[1].position;
        firstColumn = floorPixel(a.x + (b.x - a.x) / 16 * genes.sixteenths) - edgeWindowSide / 2;
        firstRow = floorPixel(a.y + (b.y - a.y) / 16 * genes.sixteenths) - edgeWindowSide / 2;
        width = edgeWindowSide;
        height = edgeWindowSide;
    }
    hardCase.canvas.firstColumn = std::int32_t(firstColumn);
    hardCase.canvas.firstRow = std::int32_t(firstRow);
    hardCase.canvas.width = std::int32_t(width);
    hardCase.canvas.height = std::int32_t(height);
    return isWithinFrameRange(firstColumn) && isWithinFrameRange(firstRow) && width <= largestSide
        && height <= largestSide && width * height <= largestArea;
}

} // namespace

std::optional<HardCase> expressed(const Recipe &recipe, const Genes &genes)
{
    HardCase hardCase;
    hardCase.id = QString::fromLatin1(recipe.id);
    hardCase.kind = kindOf(recipe.figure);
    const Lattice unit = unitsPerPixel / recipe.scale;
    constexpr std::array<Colour, 3> meshColours
        = {Colour{{255, 0, 0}}, Colour{{0, 255, 0}}, Colour{{0, 0, 255}}};
    for (const Corners &corners : cornersOf(recipe.figure, genes.points)) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.vertices[i].position = {corners[i].x * unit + recipe.corner.x * unitsPerPixel,
                                             corners[i].y * unit + recipe.corner.y * unitsPerPixel};
            triangle.vertices[i].colour
                = hardCase.kind == HardCaseKind::Mesh ? meshColours[i] : genes.colours[i];
            if (!isWithinRange(triangle.vertices[i].position))
                return std::nullopt;
        }
        hardCase.triangles.push_back(triangle);
    }
    if (hardCase.kind == HardCaseKind::Translation)
        hardCase.offsets = {{0, 0}, {5000, 3001}, {16001, -9973}, {-20011, -7}};
    if (!placeCanvas(recipe, genes, hardCase))
        return std::nullopt;
    if (hardCase.kind == HardCaseKind::Mesh && !isProperMesh(hardCase))
        return std::nullopt;
    return hardCase;
}

Score scoreOf(const Recipe &recipe, const HardCase &hardCase)
{
    const Shortfall shortfall
        = measure(hardCase, {recipe.arithmetic, recipe.rule, ByteRounding::Nearest});
    const std::int64_t wrongPixels = shortfall.missing + shortfall.extra;
    const std::int64_t other = wrongPixels + shortfall.wrongBytes;
    switch (recipe.stress) {
    case Stress::WrongPixels:
        return {wrongPixels, other};
    case Stress::WrongBytes:
        return {shortfall.wrongBytes, other};
    case Stress::ClampedPixels:
        return {shortfall.clamped, other};
    case Stress::GapsAndOverdraw:
        return {shortfall.gaps + shortfall.overdraw, other};
    case Stress::Flicker:
        return {shortfall.extraToggles, other};
    case Stress::Pictures:
        return {shortfall.extraPictures, other};
    }
    return {};
}

} // namespace pixelplumb::search
