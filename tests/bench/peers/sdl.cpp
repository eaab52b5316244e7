// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#define SDL_MAIN_HANDLED // main() stays ours
#include <SDL.h>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

struct SurfaceDeleter {
    void operator()(SDL_Surface *surface) const { SDL_FreeSurface(surface); }
};
struct RendererDeleter {
    void operator()(SDL_Renderer *renderer) const { SDL_DestroyRenderer(renderer); }
};

/// The software renderer truncates vertices to whole pixels (SDL_Point) and samples at pixel
/// centres, so it cannot draw our exact scene: it draws the scene shifted by half a pixel.
class Sdl final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_size = scene.size;
        m_renderer.reset();
        m_surface.reset(SDL_CreateRGBSurfaceWithFormat(0, m_size.width, m_size.height, 32,
                                                       SDL_PIXELFORMAT_ARGB8888));
        m_renderer.reset(SDL_CreateSoftwareRenderer(m_surface.get()));
        SDL_SetRenderDrawBlendMode(m_renderer.get(), SDL_BLENDMODE_NONE);
        m_vertices.clear();
        m_vertices.reserve(scene.triangles.size() * 3);
        for (const Triangle &triangle : scene.triangles) {
            for (const Vertex &vertex : triangle.vertices) {
                const PixelPoint point = pixelOf(vertex);
                const Colour &colour = vertex.colour;
                m_vertices.push_back({{float(point.x), float(m_size.height - 1 - point.y)},
                                      {colour.red(), colour.green(), colour.blue(), 255},
                                      {0, 0}});
            }
        }
    }

    void draw() override
    {
        SDL_RenderGeometry(m_renderer.get(), nullptr, m_vertices.data(), int(m_vertices.size()),
                           nullptr, 0);
        SDL_RenderFlush(m_renderer.get());
    }

    Picture picture() override
    {
        return pictureOfLines(m_size, static_cast<const unsigned char *>(m_surface->pixels),
                              m_surface->pitch);
    }

private:
    FrameSize m_size;
    std::unique_ptr<SDL_Surface, SurfaceDeleter> m_surface;
    std::unique_ptr<SDL_Renderer, RendererDeleter> m_renderer;
    std::vector<SDL_Vertex> m_vertices;
};

} // namespace

void addSdl(Lineup &lineup)
{
    SDL_version version;
    SDL_GetVersion(&version);
    ContenderInfo info;
    info.id = u"sdl2"_s;
    info.name
        = u"SDL %1.%2 RenderGeometry, software"_s.arg(int(version.major)).arg(int(version.minor));
    info.sampleOffset = {unitsPerPixel / 2, -unitsPerPixel / 2};
    lineup.contenders.push_back(std::make_unique<Sdl>(info));
}

} // namespace pixelplumb::bench
