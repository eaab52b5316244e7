// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#include <QImage>
#include <QPainter>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// Flat colour: QPainter has no brush that interpolates between three vertices.
class PainterPolygons final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_image = QImage(scene.size.width, scene.size.height, QImage::Format_RGB32);
        m_image.fill(Qt::black);
        m_polygons.clear();
        m_polygons.reserve(scene.triangles.size());
        for (const Triangle &triangle : scene.triangles) {
            Polygon polygon;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                // Pixel centres are at half coordinates, y runs downward.
                const PixelPoint point = pixelOf(triangle.vertices[corner]);
                polygon.corners[corner]
                    = QPointF(point.x + 0.5, scene.size.height - 1 - point.y + 0.5);
            }
            polygon.colour = packed(triangle.vertices[0].colour);
            m_polygons.push_back(polygon);
        }
    }

    void draw() override
    {
        QPainter painter(&m_image);
        painter.setPen(Qt::NoPen);
        for (const Polygon &polygon : m_polygons) {
            painter.setBrush(QColor(polygon.colour));
            painter.drawPolygon(polygon.corners.data(), 3);
        }
    }

    Picture picture() override
    {
        return pictureOfLines({m_image.width(), m_image.height()}, m_image.constBits(),
                              m_image.bytesPerLine());
    }

private:
    struct Polygon {
        std::array<QPointF, 3> corners;
        QRgb colour = 0;
    };

    QImage m_image;
    std::vector<Polygon> m_polygons;
};

} // namespace

void addQPainter(Lineup &lineup)
{
    ContenderInfo info;
    info.id = u"qpainter"_s;
    info.name = u"Qt %1 QPainter::drawPolygon"_s.arg(QLatin1String(qVersion()));
    info.shading = Shading::Flat;
    lineup.contenders.push_back(std::make_unique<PainterPolygons>(info));
}

} // namespace pixelplumb::bench
