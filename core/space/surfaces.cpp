// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/surfaces.h"

#include "core/space/stagenumbers.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// A Surface in one number type.
template <class Number>
struct SurfaceNumbers {
    using Vector = SpaceVector<Number>;

    explicit SurfaceNumbers(const Surface &surface)
        : kind(surface.kind)
        , origin(surface.points[0])
        , first(Vector(surface.points[1]) - origin)
        , second(Vector(surface.points[2]) - origin)
        , normal(cross(first, second))
        , radius(surface.radius)
    {
    }

    Vector point(double s, double t) const
    {
        const auto around = circlePoint(Number(s), Number(1));
        switch (kind) {
        case SurfaceKind::Line:
            return origin + Number(s) * first;
        case SurfaceKind::Circle:
            return origin + radius * Vector(around.cosine, around.sine, Number(0));
        case SurfaceKind::Plane:
            return origin + Number(s) * first + Number(t) * second;
        case SurfaceKind::Sphere:
            break;
        }
        const auto down = circlePoint(Number(t), Number(2));
        return origin
            + radius * Vector(down.sine * around.sine, down.cosine, down.sine * around.cosine);
    }

    /// 0 on the surface.
    Number implicit(const Vector &at) const
    {
        const Vector from = at - origin;
        switch (kind) {
        case SurfaceKind::Line:
            return from.x * first.y - from.y * first.x;
        case SurfaceKind::Plane:
            return dot(normal, from);
        case SurfaceKind::Circle:
        case SurfaceKind::Sphere:
            break;
        }
        return dot(from, from) - radius * radius;
    }

    /// Whether the last coordinate is a function of the others.
    bool isExplicit() const
    {
        return (kind != SurfaceKind::Line || first.x != 0)
            && (kind != SurfaceKind::Plane || normal.z != 0);
    }

    /// y of a curve or z of a surface, from the other coordinates and the branch of the root.
    Number explicitly(const Vector &at) const
    {
        using std::sqrt;
        const Vector from = at - origin;
        Number square = radius * radius - from.x * from.x;
        switch (kind) {
        case SurfaceKind::Line:
            return first.y / first.x * at.x + (origin.y - first.y / first.x * origin.x);
        case SurfaceKind::Plane:
            return origin.z - (normal.x * from.x + normal.y * from.y) / normal.z;
        case SurfaceKind::Circle:
            return origin.y + (from.y < 0 ? -1 : 1) * sqrt(square > 0 ? square : Number(0));
        case SurfaceKind::Sphere:
            break;
        }
        square -= from.y * from.y;
        return origin.z + (from.z < 0 ? -1 : 1) * sqrt(square > 0 ? square : Number(0));
    }

    SurfaceKind kind;
    Vector origin;
    Vector first;
    Vector second;
    Vector normal;
    Number radius;
};

struct FormWords {
    QString explicitly, explicitNote;
    QString parametric, parametricNote;
    QString implicit, implicitNote;
};

FormWords wordsOf(SurfaceKind kind)
{
    const QString steps = "gives every point in turn, also where the line is steep";
    const QString sides = "its sign tells the side on which a point lies; k·F is 0 there as well";
    switch (kind) {
    case SurfaceKind::Line:
        return {"y = m·x + b, m = (y₁ − y₀)/(x₁ − x₀), b = y₀ − m·x₀",
                "one y for each x; none for a vertical line",
                "P(s) = P₀ + s·(P₁ − P₀)",
                steps,
                "F(x, y) = (x − x₀)·(y₁ − y₀) − (y − y₀)·(x₁ − x₀) = 0",
                sides};
    case SurfaceKind::Circle:
        return {"y = y_c ± √(r² − (x − x_c)²)",
                "two branches; their slope is infinite at x_c ± r",
                "P(s) = C + r·(cos 2πs, sin 2πs)",
                "equal steps of s are equal steps along it; 5s names the same points",
                "F(x, y) = (x − x_c)² + (y − y_c)² − r² = 0",
                "below 0 inside, above 0 outside"};
    case SurfaceKind::Plane:
        return {"z = z₀ − (N_x·(x − x₀) + N_y·(y − y₀))/N_z, N = (P₁ − P₀) × (P₂ − P₀)",
                "one z for each (x, y); none for a plane along z",
                "P(s, t) = P₀ + s·(P₁ − P₀) + t·(P₂ − P₀)",
                "with 0 ≤ s, t ≤ 1 the parallelogram that a scene draws",
                "F(P) = N·(P − P₀) = 0",
                sides};
    case SurfaceKind::Sphere:
        break;
    }
    return {"z = z_c ± √(r² − (x − x_c)² − (y − y_c)²)",
            "two branches; their slope is infinite around the rim",
            "P(s, t) = C + r·(sin πt·sin 2πs, cos πt, sin πt·cos 2πs)",
            "segments are equal steps of s and t; all s meet at the poles",
            "F(P) = (P − C)·(P − C) − r² = 0",
            "below 0 inside, above 0 outside"};
}

} // namespace

QString nameOf(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::Line:
        return u"line"_s;
    case SurfaceKind::Circle:
        return u"circle"_s;
    case SurfaceKind::Plane:
        return u"plane"_s;
    case SurfaceKind::Sphere:
        return u"sphere"_s;
    }
    return {};
}

std::vector<SurfaceForm> formsOf(const Surface &surface, double s, double t)
{
    const SurfaceNumbers<double> used(surface);
    const SurfaceNumbers<ExactReal> exact(surface);
    const SpaceVector<double> usedPoint = used.point(s, t);
    const SpaceVector<ExactReal> exactPoint = exact.point(s, t);
    const FormWords words = wordsOf(surface.kind);
    const bool isCurve = surface.kind == SurfaceKind::Line || surface.kind == SurfaceKind::Circle;
    SurfaceForm explicitly{"explicit", words.explicitly, words.explicitNote, {}};
    if (used.isExplicit() && exact.isExplicit()) {
        StageNumberWriter(explicitly.numbers)
            .add(isCurve ? u"y"_s : u"z"_s, used.explicitly(usedPoint),
                 exact.explicitly(exactPoint));
    }
    SurfaceForm parametric{"parametric", words.parametric, words.parametricNote, {}};
    StageNumberWriter point(parametric.numbers);
    point.add("x", usedPoint.x, exactPoint.x);
    point.add("y", usedPoint.y, exactPoint.y);
    if (!isCurve)
        point.add("z", usedPoint.z, exactPoint.z);
    SurfaceForm implicit{"implicit", words.implicit, words.implicitNote, {}};
    StageNumberWriter(implicit.numbers).add("F", used.implicit(usedPoint), ExactReal(0));
    return {explicitly, parametric, implicit};
}

} // namespace pixelplumb
