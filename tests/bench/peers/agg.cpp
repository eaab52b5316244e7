// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#include <agg_gamma_functions.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_bin.h>
#include <agg_span_allocator.h>
#include <agg_span_gouraud_rgba.h>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// AGG has no Gouraud path without its coverage rasteriser. A gamma with a threshold at one half
/// switches antialiasing off: a pixel is written if half of its area is covered, wherever its
/// centre lies.
class Agg final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_size = scene.size;
        m_triangles = scene.triangles;
        m_pixels.assign(std::size_t(m_size.width) * std::size_t(m_size.height), 0);
        m_buffer.attach(reinterpret_cast<agg::int8u *>(m_pixels.data()), unsigned(m_size.width),
                        unsigned(m_size.height), m_size.width * 4);
        m_rasterizer.gamma(agg::gamma_threshold(0.5));
    }

    void draw() override
    {
        using PixelFormat = agg::pixfmt_bgra32;
        using Renderer = agg::renderer_base<PixelFormat>;
        PixelFormat format(m_buffer);
        Renderer renderer(format);
        agg::span_allocator<agg::rgba8> allocator;
        agg::scanline_bin scanline;
        agg::span_gouraud_rgba<agg::rgba8> spans;
        for (const Triangle &triangle : m_triangles) {
            const auto &vertices = triangle.vertices;
            const std::array<Corner, 3> corners
                = {cornerOf(vertices[0]), cornerOf(vertices[1]), cornerOf(vertices[2])};
            spans.colors(corners[0].colour, corners[1].colour, corners[2].colour);
            spans.triangle(corners[0].x, corners[0].y, corners[1].x, corners[1].y, corners[2].x,
                           corners[2].y, 0);
            m_rasterizer.reset();
            m_rasterizer.add_path(spans);
            agg::render_scanlines_bin(m_rasterizer, scanline, renderer, allocator, spans);
        }
    }

    Picture picture() override
    {
        return pictureOfLines(m_size, reinterpret_cast<const unsigned char *>(m_pixels.data()),
                              std::ptrdiff_t(m_size.width) * 4);
    }

private:
    struct Corner {
        double x;
        double y;
        agg::rgba8 colour;
    };

    /// Pixel centres are at half coordinates, y runs downward.
    Corner cornerOf(const Vertex &vertex) const
    {
        const PixelPoint point = pixelOf(vertex);
        return {point.x + 0.5, m_size.height - 1 - point.y + 0.5,
                agg::rgba8(vertex.colour.red(), vertex.colour.green(), vertex.colour.blue())};
    }

    FrameSize m_size;
    std::span<const Triangle> m_triangles;
    std::vector<std::uint32_t> m_pixels;
    agg::rendering_buffer m_buffer;
    agg::rasterizer_scanline_aa<> m_rasterizer;
};

} // namespace

void addAgg(Lineup &lineup)
{
    ContenderInfo info;
    info.id = u"agg"_s;
    info.name = u"AGG span_gouraud_rgba, AA off by gamma"_s;
    lineup.contenders.push_back(std::make_unique<Agg>(info));
}

} // namespace pixelplumb::bench
