// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#define ALLEGRO_NO_MAGIC_MAIN // main() stays ours
#include <allegro.h>

#include <cerrno>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

struct BitmapDeleter {
    void operator()(BITMAP *bitmap) const { destroy_bitmap(bitmap); }
};

class Allegro final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_size = scene.size;
        m_bitmap.reset(create_bitmap_ex(32, m_size.width, m_size.height));
        clear_bitmap(m_bitmap.get());
        m_vertices.clear();
        m_vertices.reserve(scene.triangles.size() * 3);
        for (const Triangle &triangle : scene.triangles) {
            for (const Vertex &vertex : triangle.vertices) {
                const PixelPoint point = pixelOf(vertex);
                m_vertices.push_back({float(point.x), float(m_size.height - 1 - point.y), 0, 0, 0,
                                      int(packed(vertex.colour) & 0xffffff)});
            }
        }
    }

    void draw() override
    {
        for (std::size_t first = 0; first < m_vertices.size(); first += 3) {
            triangle3d_f(m_bitmap.get(), POLYTYPE_GRGB, nullptr, &m_vertices[first],
                         &m_vertices[first + 1], &m_vertices[first + 2]);
        }
    }

    Picture picture() override
    {
        Picture picture(m_size);
        for (int y = 0; y < m_size.height; ++y) {
            for (int x = 0; x < m_size.width; ++x) {
                const int pixel = getpixel(m_bitmap.get(), x, m_size.height - 1 - y);
                picture.set(x, y, qRgb(getr32(pixel), getg32(pixel), getb32(pixel)));
            }
        }
        return picture;
    }

private:
    FrameSize m_size;
    std::unique_ptr<BITMAP, BitmapDeleter> m_bitmap;
    std::vector<V3D_f> m_vertices;
};

} // namespace

void addAllegro(Lineup &lineup)
{
    // Only memory bitmaps: no window, no driver, no exit function.
    if (install_allegro(SYSTEM_NONE, &errno, nullptr) != 0) {
        lineup.absent.push_back(
            {u"Allegro 4"_s,
             u"install_allegro(SYSTEM_NONE) failed: %1"_s.arg(QLatin1String(allegro_error))});
        return;
    }
    set_color_depth(32);
    ContenderInfo info;
    info.id = u"allegro"_s;
    info.name = QStringLiteral("Allegro " ALLEGRO_VERSION_STR " triangle3d_f");
    lineup.contenders.push_back(std::make_unique<Allegro>(info));
}

} // namespace pixelplumb::bench
