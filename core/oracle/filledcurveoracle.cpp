// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/filledcurveoracle.h"

#include "core/oracle/curvecells.h"
#include "core/oracle/truepixel.h"

#include <algorithm>
#include <array>
#include <span>

namespace pixelplumb::oracle {

namespace {

/// A coordinate and its displacement need 39 bits, and each halving of a cubic three more.
constexpr int deepestPathCut = 28;

struct PathPiece {
    CurveControlsOf<Int128> x, y;
    int depth = 0; ///< halvings

    Int128 pixel() const { return Int128(unitsPerPixel) << (int(x.degree()) * depth); }
};

PathPiece pathPieceOf(std::span<const Vertex> controls)
{
    std::array<Int128, 4> x = {}, y = {};
    for (std::size_t i = 0; i < controls.size(); ++i) {
        x[i] = controls[i].position.x;
        y[i] = controls[i].position.y;
    }
    return {{x, controls.size()}, {y, controls.size()}};
}

/// The curves and the straight edges between them.
std::vector<PathPiece> pathPiecesOf(const Shape &path)
{
    std::vector<PathPiece> pieces;
    const auto joinTo = [&](const Vertex &from, const Vertex &to) {
        if (from.position != to.position)
            pieces.push_back(pathPieceOf(std::array{from, to}));
    };
    const std::span<const Vertex> vertices = path.vertices;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= path.laterContours.size(); ++i) {
        const std::size_t end
            = i < path.laterContours.size() ? path.laterContours[i] : vertices.size();
        if (first > 0)
            joinTo(vertices[first - 1], vertices[first]);
        pieces.push_back(pathPieceOf(vertices.subspan(first, end - first)));
        first = end;
    }
    joinTo(vertices.back(), vertices.front());
    return pieces;
}

/// The winding number of a row changes by `by` from a column on.
struct Turn {
    std::int64_t column = 0;
    int by = 0;
};

/// Appends a piece's contribution to a row.
class RowTurns {
public:
    RowTurns(std::int64_t row, FrameOrigin origin)
        : m_row(row)
        , m_origin(origin)
    {
    }

    void append(const PathPiece &piece)
    {
        const Int128 pixel = piece.pixel();
        const Int128 height = m_row * pixel;
        if (isAbove(piece.y.lowest(), height) == isAbove(piece.y.highest(), height))
            return;
        const int turn
            = int(isAbove(piece.y.last(), height)) - int(isAbove(piece.y.first(), height));
        if (piece.x.degree() == 1) {
            m_turns.push_back({columnOfChord(piece), turn});
            return;
        }
        const std::int64_t column = ceilDivided(piece.x.lowest(), pixel);
        const bool isBetweenColumns = column * pixel >= piece.x.highest();
        if (!isBetweenColumns && piece.depth < deepestPathCut) {
            append({piece.x.leftHalf(), piece.y.leftHalf(), piece.depth + 1});
            append({piece.x.rightHalf(), piece.y.rightHalf(), piece.depth + 1});
            return;
        }
        if (turn != 0)
            m_turns.push_back({isBetweenColumns ? column : columnOfChord(piece), turn});
    }
    const std::vector<Turn> &turns() const { return m_turns; }
    std::vector<Turn> sorted()
    {
        std::ranges::sort(m_turns, {}, &Turn::column);
        return m_turns;
    }

private:
    /// Displaced down on screen, a sample lies below whatever is level with it.
    bool isAbove(const Int128 &y, const Int128 &height) const
    {
        return m_origin == FrameOrigin::TopLeft ? y > height : y >= height;
    }
    /// The first column whose sample lies where a piece's chord crosses the row, or right of that.
    std::int64_t columnOfChord(const PathPiece &piece) const
    {
        using Wide = boost::multiprecision::cpp_int;
        const Wide height = Wide(m_row) * Wide(piece.pixel());
        const Wide rise = Wide(piece.y.last()) - Wide(piece.y.first());
        const Wide x = Wide(piece.x.first()) * rise
            + (Wide(piece.x.last()) - Wide(piece.x.first())) * (height - Wide(piece.y.first()));
        const Wide unit = (rise < 0 ? -rise : rise) * Wide(piece.pixel());
        Wide column, rest;
        boost::multiprecision::divide_qr(Wide(rise < 0 ? -x : x), unit, column, rest);
        return std::int64_t(column) + (rest > 0 ? 1 : 0);
    }
    static std::int64_t ceilDivided(const Int128 &value, const Int128 &pixel)
    {
        return -std::int64_t(floorDivide<Int128>(-value, pixel));
    }

    std::int64_t m_row;
    FrameOrigin m_origin;
    std::vector<Turn> m_turns;
};

RowTurns turnsOn(std::int64_t row, FrameOrigin origin, const std::vector<PathPiece> &pieces)
{
    RowTurns turns(row, origin);
    for (const PathPiece &piece : pieces)
        turns.append(piece);
    return turns;
}

bool isInsidePath(std::int64_t winding, ShapeFill fill)
{
    return fill == ShapeFill::NonZero ? winding != 0 : winding % 2 != 0;
}

} // namespace

bool filledCurveCovers(const Shape &path, FrameOrigin origin, std::int64_t x, std::int64_t y)
{
    const RowTurns row = turnsOn(y, origin, pathPiecesOf(path));
    std::int64_t winding = 0;
    for (const Turn &turn : row.turns())
        winding += turn.column <= x ? turn.by : 0;
    return isInsidePath(winding, path.fill);
}

void drawFilledCurve(const Shape &path, FrameView frame)
{
    const std::vector<PathPiece> pieces = pathPiecesOf(path);
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        const std::vector<Turn> turns = turnsOn(y, frame.origin, pieces).sorted();
        std::int64_t winding = 0;
        for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
            winding += turns[i].by;
            if (!isInsidePath(winding, path.fill))
                continue;
            const std::int64_t end = std::min(turns[i + 1].column, frame.endColumn());
            for (std::int64_t x = std::max<std::int64_t>(turns[i].column, frame.firstColumn);
                 x < end; ++x)
                writeTruePixel(frame, x, y, path.vertices.front().colour);
        }
    }
}

} // namespace pixelplumb::oracle
