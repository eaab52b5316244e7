// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/tests/planearithmetic.h"

#include <algorithm>

namespace pixelplumb {

/// How the line through two vertices becomes an equation. In exact numbers all forms are equal;
/// they differ in how they round. Absolute: Scan Conversion slides, "Implicit Equation for a 2D
/// line". Solved: Rasterization slides, "Given 2 points, compute A,B,C". CommonVertex:
/// Rasterization slides, "Cramer's Rule".
enum class LineForm {
    Absolute, ///< a·x + b·y + c with c computed from the coordinates
    Solved, ///< the same with a and b from the 2×2 system, c chosen as −1
    CanonicalEnd, ///< a·(x − u) + b·(y − v) from the end point that is smaller in (x, y) order
    FirstEnd, ///< the same from the edge's first end point
    CommonVertex, ///< the same from the triangle's last vertex
};

inline constexpr Int128 squareUnitsPerPixel = Int128(unitsPerPixel) * unitsPerPixel;

/// The equation of the line through two vertices: 0 on the line, one sign on each side. A = y₁ −
/// y₀, B = x₀ − x₁, C = x₁y₀ − x₀y₁ (Scan Conversion slides, "Implicit Equation for a 2D line", its
/// misprint corrected), times `sign`.
template <class A>
struct EdgeLine {
    using Number = typename A::Number;

    Number a = {}; ///< change of the value for each step of x
    Number b = {}; ///< change of the value for each step of y
    Number c = {}; ///< the value at (0, 0), where the form has it
    LatticePoint origin; ///< (u, v), where the form has it
    Number determinant = {}; ///< x₀y₁ − y₀x₁, of the solved form
    WideBeside<Number> unit = squareUnitsPerPixel; ///< the exact value that stands for 1
    int sign = 1; ///< −1 after a flip

    EdgeLine() = default;
    [[gnu::always_inline]] EdgeLine(LineForm form, const LatticePoint &p, const LatticePoint &q,
                                    const LatticePoint &common)
    {
        switch (form) {
        case LineForm::Absolute:
            setAbsolute(p, q);
            return;
        case LineForm::Solved:
            solve(p, q);
            return;
        case LineForm::CanonicalEnd:
            setRelative(std::min(p, q), std::max(p, q));
            if (q < p)
                flip();
            sign = 1;
            return;
        case LineForm::FirstEnd:
            setRelative(p, q);
            return;
        case LineForm::CommonVertex:
            a = A::length(q.y) - A::length(p.y);
            b = A::length(p.x) - A::length(q.x);
            origin = p == common || q == common ? common : p;
            return;
        }
    }

    /// The value at a point. The stable forms subtract on the lattice, where nothing rounds; the
    /// slides' CommonVertex subtracts the rounded coordinates.
    template <LineForm form>
    [[gnu::always_inline]] Number valueAt(const LatticePoint &point) const
    {
        if constexpr (form == LineForm::Absolute || form == LineForm::Solved)
            return a * A::length(point.x) + b * A::length(point.y) + c;
        else if constexpr (form == LineForm::CommonVertex)
            return a * (A::length(point.x) - A::length(origin.x))
                + b * (A::length(point.y) - A::length(origin.y));
        else
            return a * A::distance(origin.x, point.x) + b * A::distance(origin.y, point.y);
    }

    /// Exchanges the sides (Rasterization slides, "Edge Equations": "Reverse spaces by
    /// multiplication by −1").
    void flip()
    {
        // Not −a, which would turn 0 into −0.
        a = Number(0) - a;
        b = Number(0) - b;
        c = Number(0) - c;
        sign = -sign;
    }

private:
    void setAbsolute(const LatticePoint &p, const LatticePoint &q)
    {
        const Number x0 = A::length(p.x), y0 = A::length(p.y);
        const Number x1 = A::length(q.x), y1 = A::length(q.y);
        a = y1 - y0;
        b = x0 - x1;
        c = x1 * y0 - x0 * y1;
    }

    void setRelative(const LatticePoint &from, const LatticePoint &to)
    {
        a = A::distance(from.y, to.y);
        b = A::distance(to.x, from.x);
        origin = from;
    }

    /// (a, b) = −c/determinant · (y₁ − y₀, x₀ − x₁) with c = −1. A line through (0, 0) has the
    /// determinant 0 and no such solution; there c = 0 and the pair itself serves. Exact values
    /// keep the determinant as their unit instead of dividing by it.
    void solve(const LatticePoint &p, const LatticePoint &q)
    {
        const Number x0 = A::length(p.x), y0 = A::length(p.y);
        const Number x1 = A::length(q.x), y1 = A::length(q.y);
        determinant = x0 * y1 - y0 * x1;
        a = y1 - y0;
        b = x0 - x1;
        c = Number(0);
        if (determinant == Number(0))
            return;
        if constexpr (A::arithmetic == Arithmetic::Exact) {
            const bool isNegative = determinant < 0;
            unit = isNegative ? -determinant : determinant;
            a = isNegative ? -a : a;
            b = isNegative ? -b : b;
            c = -unit;
        } else {
            a = a / determinant;
            b = b / determinant;
            c = Number(-1);
        }
    }
};

} // namespace pixelplumb
