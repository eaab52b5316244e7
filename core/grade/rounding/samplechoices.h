// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

namespace pixelplumb {

/// The triangles that right programs draw at a sample, as ascending indices. Which of the open ones
/// a program draws, it may choose; under Leeway::Once not each for itself: triangles that lie side
/// by side at the sample, on both sides of an edge, are drawn as if the sample stood a hair beside
/// it, in whichever direction. So an edge between two triangles gives it to one of them, and a
/// vertex inside a mesh to one of the triangles round it.
class SampleChoice {
public:
    SampleChoice(const std::vector<Triangle> &triangles, std::int64_t x, std::int64_t y)
        : m_triangles(&triangles)
        , m_x(x)
        , m_y(y)
    {
    }

    std::int64_t x() const { return m_x; }
    std::int64_t y() const { return m_y; }
    /// The index of its pixel in a picture of the frame, line by line, the top line first.
    std::size_t placeIn(const FrameSpec &frame) const;
    void addDrawn(std::size_t triangle) { m_drawn.push_back(triangle); }
    void addOpen(std::size_t triangle) { m_open.push_back(triangle); }

    bool isDecided() const { return m_open.empty(); }
    /// What all right programs draw here.
    const std::vector<std::size_t> &drawn() const { return m_drawn; }
    const std::vector<std::size_t> &open() const { return m_open; }
    /// The sets of triangles of which a right program may draw one here, the drawn ones among them;
    /// not all of very many.
    std::vector<std::vector<std::size_t>> sets(Leeway leeway) const;
    /// Whether the sample lies on an edge and has triangles on all sides, so that it is a hole if
    /// none is drawn there.
    bool isSurrounded() const;
    bool isVertex() const; ///< of an open triangle

private:
    const std::vector<Triangle> *m_triangles;
    std::int64_t m_x, m_y;
    std::vector<std::size_t> m_drawn, m_open;
};

/// The choices at the frame's samples where `wanted`, line by line, the top line first, holds a 1
/// and some triangle may be drawn. The triangles are in sample coordinates, and outlive them.
std::vector<SampleChoice> sampleChoicesOf(const std::vector<Triangle> &triangles,
                                          const Scene &scene, const Margin &margin,
                                          const std::vector<std::uint8_t> &wanted);

/// Which of these bare pixels are holes: their sample lies on an edge and has triangles on all
/// sides. Rounding moves an edge for both of its triangles alike, so that what leaves one is in the
/// other. No holes are, unless the leeway is Once, those where edge functions, which each triangle
/// evaluates for itself, may leave the sample out of both, and those at vertices, where one
/// triangle may end at a rounded number and the next begin at an exact one.
std::vector<std::uint8_t> holesAmong(const std::vector<std::uint8_t> &bare, const Scene &scene,
                                     const Margin &margin);

} // namespace pixelplumb
