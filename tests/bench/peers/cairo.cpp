// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#include <cairo.h>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

struct SurfaceDeleter {
    void operator()(cairo_surface_t *surface) const { cairo_surface_destroy(surface); }
};
struct PatternDeleter {
    void operator()(cairo_pattern_t *pattern) const { cairo_pattern_destroy(pattern); }
};

/// All triangles as patches of one mesh pattern, painted once: painting each alone would charge the
/// composition of the whole frame to every triangle. Cairo draws a patch as so many points on
/// Bézier curves that none of its pixels is left out ("forward rasterization"): every pixel that
/// the triangle touches is written, in the colour of the last point that fell into it.
class Cairo final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_size = scene.size;
        m_surface.reset(
            cairo_image_surface_create(CAIRO_FORMAT_RGB24, m_size.width, m_size.height));
        m_pattern.reset(cairo_pattern_create_mesh());
        for (const Triangle &triangle : scene.triangles)
            addPatch(triangle);
    }

    void draw() override
    {
        cairo_t *context = cairo_create(m_surface.get());
        cairo_set_source(context, m_pattern.get());
        cairo_paint(context);
        cairo_destroy(context);
        cairo_surface_flush(m_surface.get());
    }

    Picture picture() override
    {
        return pictureOfLines(m_size, cairo_image_surface_get_data(m_surface.get()),
                              cairo_image_surface_get_stride(m_surface.get()));
    }

private:
    /// Pixel centres are at half coordinates, y runs downward.
    void addPatch(const Triangle &triangle)
    {
        cairo_pattern_t *pattern = m_pattern.get();
        cairo_mesh_pattern_begin_patch(pattern);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const PixelPoint point = pixelOf(triangle.vertices[corner]);
            const double x = point.x + 0.5;
            const double y = m_size.height - 1 - point.y + 0.5;
            if (corner == 0)
                cairo_mesh_pattern_move_to(pattern, x, y);
            else
                cairo_mesh_pattern_line_to(pattern, x, y);
        }
        for (unsigned corner = 0; corner < 3; ++corner) {
            const Colour &colour = triangle.vertices[corner].colour;
            cairo_mesh_pattern_set_corner_color_rgb(pattern, corner, colour.red() / 255.0,
                                                    colour.green() / 255.0, colour.blue() / 255.0);
        }
        cairo_mesh_pattern_end_patch(pattern);
    }

    FrameSize m_size;
    std::unique_ptr<cairo_surface_t, SurfaceDeleter> m_surface;
    std::unique_ptr<cairo_pattern_t, PatternDeleter> m_pattern;
};

} // namespace

void addCairo(Lineup &lineup)
{
    ContenderInfo info;
    info.id = u"cairo"_s;
    info.name = u"Cairo %1 mesh pattern"_s.arg(QLatin1String(cairo_version_string()));
    lineup.contenders.push_back(std::make_unique<Cairo>(info));
}

} // namespace pixelplumb::bench
