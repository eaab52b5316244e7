// SPDX-License-Identifier: GPL-3.0-or-later
#include "lineup.h"

#include <QImage>

#include <cmath>

/// The assignment (Borst) as a student hands it in: floats, increments, QImage::setPixel. It is
/// written only to be recognisable and shares nothing with the kernels.
namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

struct StudentVertex {
    float x, y, r, g, b;
};

class Student {
public:
    explicit Student(QImage &image)
        : m_image(image)
    {
    }

    void drawTriangle(const StudentVertex &a, const StudentVertex &b, const StudentVertex &c)
    {
        const StudentVertex *v0 = &a;
        const StudentVertex *v1 = &b;
        const StudentVertex *v2 = &c;
        if (v1->x < v0->x)
            std::swap(v0, v1);
        if (v2->x < v1->x)
            std::swap(v1, v2);
        if (v1->x < v0->x)
            std::swap(v0, v1);

        Edge longEdge(*v0, *v2);
        if (v0->x < v1->x) {
            Edge edge01(*v0, *v1);
            for (int x = int(v0->x); x <= int(v1->x) - 1; ++x) {
                drawColumn(x, edge01, longEdge);
                edge01.step();
                longEdge.step();
            }
        }
        if (v1->x < v2->x) {
            Edge edge12(*v1, *v2);
            for (int x = int(v1->x); x <= int(v2->x); ++x) {
                drawColumn(x, edge12, longEdge);
                edge12.step();
                longEdge.step();
            }
        } else {
            // A vertical edge: one column, from vertex 1 to the end of the long edge.
            const Edge corner(*v1, *v1);
            drawColumn(int(v1->x), corner, v0->x < v2->x ? longEdge : Edge(*v0, *v0));
        }
    }

private:
    struct Edge {
        float y, r, g, b;
        float slope = 0, dr = 0, dg = 0, db = 0; // per column

        Edge(const StudentVertex &from, const StudentVertex &to)
            : y(from.y)
            , r(from.r)
            , g(from.g)
            , b(from.b)
        {
            const float width = to.x - from.x;
            if (width == 0)
                return;
            slope = (to.y - from.y) / width;
            dr = (to.r - from.r) / width;
            dg = (to.g - from.g) / width;
            db = (to.b - from.b) / width;
        }

        void step()
        {
            y += slope;
            r += dr;
            g += dg;
            b += db;
        }
    };

    void drawColumn(int x, const Edge &first, const Edge &second)
    {
        const Edge &bottom = first.y <= second.y ? first : second;
        const Edge &top = first.y <= second.y ? second : first;
        const int yFirst = int(std::ceil(bottom.y));
        const int yLast = int(std::floor(top.y));
        const float height = top.y - bottom.y;
        const float dr = height > 0 ? (top.r - bottom.r) / height : 0;
        const float dg = height > 0 ? (top.g - bottom.g) / height : 0;
        const float db = height > 0 ? (top.b - bottom.b) / height : 0;
        const float start = float(yFirst) - bottom.y;
        float r = bottom.r + start * dr;
        float g = bottom.g + start * dg;
        float b = bottom.b + start * db;
        for (int y = yFirst; y <= yLast; ++y) {
            // NOLINTNEXTLINE(bugprone-incorrect-roundings): as students round
            const QRgb colour = qRgb(int(r + 0.5f), int(g + 0.5f), int(b + 0.5f));
            m_image.setPixel(x, m_image.height() - 1 - y, colour);
            r += dr;
            g += dg;
            b += db;
        }
    }

    QImage &m_image;
};

class Assignment final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_image = QImage(scene.size.width, scene.size.height, QImage::Format_RGB32);
        m_image.fill(Qt::black);
        m_triangles = scene.triangles;
    }

    void draw() override
    {
        Student student(m_image);
        for (const Triangle &triangle : m_triangles) {
            student.drawTriangle(studentVertex(triangle.vertices[0]),
                                 studentVertex(triangle.vertices[1]),
                                 studentVertex(triangle.vertices[2]));
        }
    }

    Picture picture() override
    {
        return pictureOfLines({m_image.width(), m_image.height()}, m_image.constBits(),
                              m_image.bytesPerLine());
    }

private:
    static StudentVertex studentVertex(const Vertex &vertex)
    {
        const PixelPoint point = pixelOf(vertex);
        return {float(point.x), float(point.y), float(vertex.colour.red()),
                float(vertex.colour.green()), float(vertex.colour.blue())};
    }

    QImage m_image;
    std::span<const Triangle> m_triangles;
};

} // namespace

void addAssignment(Lineup &lineup)
{
    ContenderInfo info;
    info.id = u"assignment"_s;
    info.name = u"the assignment, QImage::setPixel, float32"_s;
    info.role = Role::Student;
    lineup.contenders.push_back(std::make_unique<Assignment>(info));
}

} // namespace pixelplumb::bench
