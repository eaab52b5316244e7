// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/invariants.h"

#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/grade/try/sampleview.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int viewSide = SampleView::side;
constexpr int shift = 3; // px

/// Samples in both triangles lie on the shared edge; under a watertight rule there are none.
bool areOnce(const SampleView &one, const SampleView &other, const Triangle &triangle,
             FillRule rule)
{
    const LatticePoint &from = triangle.vertices[0].position;
    const LatticePoint &to = triangle.vertices[1].position;
    return SampleView::holdsEverywhere([&](int x, int y) {
        const bool isOnEdge = doubledArea(from, to, latticePixel(x, y)) == 0;
        const bool isBoth = one.covers(x, y) && other.covers(x, y);
        return !isBoth || (rule == FillRule::Closed && isOnEdge);
    });
}

class InvariantCheck {
public:
    InvariantCheck(const PictureSource &source, const Scene &conventions)
        : m_source(source)
        , m_conventions(conventions)
    {
        m_conventions.frame.width = viewSide;
        m_conventions.frame.height = viewSide;
        m_conventions.triangles.clear();
        m_conventions.shapes.clear();
    }

    void check(const Triangle &one, const Triangle &other)
    {
        m_drewAll = true;
        checkAll(one, other);
        ++(m_drewAll ? m_report.checked : m_report.undrawn);
    }
    InvariantReport report() && { return std::move(m_report); }

private:
    std::optional<Picture> pictureOf(const Scene &scene)
    {
        Result<Picture> picture = m_source.draw(scene);
        if (picture)
            return std::move(*picture);
        m_drewAll = false;
        if (!m_report.firstUndrawn)
            m_report.firstUndrawn = UndrawnScene{scene, m_source.name, picture.error()};
        return std::nullopt;
    }
    void checkAll(const Triangle &one, const Triangle &other)
    {
        const auto scene = sceneOf({one});
        const auto picture = pictureOf(scene);
        const auto neighbour = pictureOf(sceneOf({other}));
        const Scene both = sceneOf({one, other});
        const auto whole = pictureOf(both);
        if (!m_drewAll)
            return;
        const FillRule rule = m_conventions.settings.fillRule;
        const SampleView view(scene, *picture);
        note(Invariant::Runs, view.hasRuns(), scene);
        if (isConvex(one, other) && rule != FillRule::Open)
            note(Invariant::Runs, SampleView(both, *whole).hasRuns(), both);
        note(Invariant::Bounds, view.isWithinBoxOf(one), scene);
        note(Invariant::Range, view.isWithinLevelsOf(one), scene);
        note(Invariant::Corners, view.hasCornersOf(one), scene);
        note(Invariant::Count, view.hasCountOf(one, rule), scene);
        note(Invariant::Once, areOnce(view, SampleView(scene, *neighbour), one, rule), both);
        const auto &[a, b, c] = one.vertices;
        for (const Triangle &ordered : {Triangle{{b, c, a}}, Triangle{{b, a, c}}}) {
            if (const auto same = pictureOf(sceneOf({ordered})))
                note(Invariant::Order, same->colours == picture->colours, scene);
        }
        checkTranslation(one, view, scene);
    }
    Scene sceneOf(const std::vector<Triangle> &triangles) const
    {
        Scene scene = m_conventions;
        scene.triangles = triangles;
        return scene;
    }
    /// Whether the triangles lie on both sides of their edge and form a convex quadrilateral: its
    /// diagonals cross.
    static bool isConvex(const Triangle &one, const Triangle &other)
    {
        const auto at = [](const Vertex &vertex) { return vertex.position; };
        const LatticePoint apex = at(one.vertices[2]);
        const LatticePoint far = at(other.vertices[2]);
        const LatticePoint from = at(one.vertices[0]);
        const LatticePoint to = at(one.vertices[1]);
        const auto parts = [](const LatticePoint &a, const LatticePoint &b, const LatticePoint &p,
                              const LatticePoint &q) {
            const Int128 left = doubledArea(a, b, p);
            const Int128 right = doubledArea(a, b, q);
            return (left < 0 && right > 0) || (left > 0 && right < 0);
        };
        return parts(from, to, apex, far) && parts(apex, far, from, to);
    }
    void checkTranslation(const Triangle &triangle, const SampleView &view, const Scene &scene)
    {
        Triangle moved = triangle;
        for (Vertex &vertex : moved.vertices) {
            vertex.position.x += shift * unitsPerPixel;
            vertex.position.y += shift * unitsPerPixel;
        }
        Scene movedScene = sceneOf({moved});
        // The rule depends on the off-screen point, which moves along.
        const LatticePoint point = offScreenSample(scene.frame);
        const Lattice by = shift * unitsPerPixel + sampleOffset(scene.frame);
        movedScene.frame.offScreenPoint = LatticePoint{point.x + by, point.y + by};
        const auto picture = pictureOf(movedScene);
        if (!picture)
            return;
        const SampleView there(movedScene, *picture);
        note(Invariant::Translation, SampleView::holdsEverywhere([&](int x, int y) {
                 if (x + shift >= viewSide || y + shift >= viewSide)
                     return true;
                 const bool covers = view.covers(x, y);
                 return covers == there.covers(x + shift, y + shift)
                     && (!covers || there.hasColourAt(x + shift, y + shift, view.colourAt(x, y)));
             }),
             scene);
    }
    void note(Invariant invariant, bool holds, const Scene &scene)
    {
        if (!holds
            && std::ranges::find(m_report.broken, invariant, &BrokenInvariant::invariant)
                == m_report.broken.end())
            m_report.broken.push_back({invariant, scene});
    }

    const PictureSource &m_source;
    Scene m_conventions;
    InvariantReport m_report;
    bool m_drewAll = true; ///< for the current pair
};

} // namespace

QString nameOf(Invariant invariant)
{
    constexpr std::array names
        = {"runs", "bounds", "range", "corners", "count", "order", "translation", "once"};
    return QString::fromLatin1(names[std::size_t(invariant)]);
}

QString sentenceOf(Invariant invariant)
{
    constexpr std::array sentences = {
        "rows and columns of a triangle, and of two that make a convex whole, have no gaps",
        "nothing is drawn outside the triangle's box",
        "levels lie between those of the vertices",
        "a vertex on a sample has its colour there",
        "whole vertices: as many samples as Pick's theorem says for the fill rule",
        "the order of the vertices does not matter",
        "moved by whole pixels, the picture moves",
        "two triangles share no sample but as the fill rule says",
    };
    return QString::fromLatin1(sentences[std::size_t(invariant)]);
}

InvariantReport checkInvariants(const PictureSource &source, const Scene &conventions,
                                std::uint64_t seed, int pairs)
{
    SeededRandom random(seed);
    InvariantCheck check(source, conventions);
    for (int i = 0; i < pairs; ++i) {
        const Lattice unit = i % 2 == 0 ? unitsPerPixel : unitsPerPixel / 2;
        const auto vertex = [&] {
            const auto coordinate = [&] {
                return random.between(unitsPerPixel / unit,
                                      (viewSide - shift - 2) * unitsPerPixel / unit)
                    * unit;
            };
            return Vertex{{coordinate(), coordinate()}, random.colour()};
        };
        const Vertex a = vertex();
        Vertex b = vertex();
        if (i % 4 == 2) // makes an edge along a row or a column
            (i % 8 == 2 ? b.position.x : b.position.y) = i % 8 == 2 ? a.position.x : a.position.y;
        const Triangle one{{a, b, vertex()}};
        Triangle other{{b, a, vertex()}};
        const bool isSameSide = (doubledArea(one) > 0) != (doubledArea(other) > 0);
        if (doubledArea(one) == 0 || doubledArea(other) == 0 || isSameSide)
            continue; // they would overlap
        check.check(one, other);
    }
    return std::move(check).report();
}

} // namespace pixelplumb
