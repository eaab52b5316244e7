// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/methodsummary.h"

#include "core/methods/method.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

constexpr const char *context = "pixelplumb::MethodSummary";

/// A list for lupdate only. At run time sentences are looked up by the methods' text, not here.
[[maybe_unused]] constexpr const char *translatableSummaries[] = {
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Walks the columns between two edges and colours the samples from y_B to "
                      "y_T that the fill rule takes, all by adding increments."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Walks the rows between two edges, the largest y first, switches in the "
                      "third edge at the middle vertex, and colours the samples from x_L to x_R "
                      "that the fill rule takes, trapezoid by trapezoid, all by adding "
                      "increments."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Evaluates E = a·x + b·y + c of the three edges at every sample of the "
                      "clipped bounding box, with the sides flipped to be positive inside; where "
                      "the slide draws E > 0 alone, E = 0 is left to the fill rule."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Adds a to each edge function along a row and b from row to row, so that a "
                      "sample costs three additions and rounding errors add up."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Solves A and B of each edge from its two points with C = −1 chosen; an edge "
                      "whose line passes through (0, 0) has no such solution and gets C = 0."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Computes α, β and γ for every pixel of the frame and draws it if all three "
                      "lie within [0, 1]; a sample on an edge is left to the fill rule."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "The same for the samples between the smallest and the largest x and y of "
                      "the vertices alone."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Adds to the weights and to the colour from sample to sample, and tests them "
                      "against 0 alone."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Solves P = C + u·(A − C) + v·(B − C) by determinants and draws if u ≥ 0, v "
                      "≥ 0 and u + v ≤ 1; a sample on an edge is left to the fill rule."),
    QT_TRANSLATE_NOOP(
        "pixelplumb::MethodSummary",
        "Gives a sample exactly on an edge to the triangle on the side of the off-screen point r: "
        "f_bc(a)·f_bc(r) > 0; an edge whose line passes through r is given to neither side."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Draws the three edges as lines of whole pixels and fills each column "
                      "from the smallest to the largest y of them: pixels nearest to an edge are "
                      "painted on whichever side of it they lie, those of a shared edge twice."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Computes y₀ + (x − x₀)·m and the plane's colours in float64 and moves them "
                      "by half the distance between their possible values before rounding: no "
                      "wrong pixel, proved for triangles in boxes of up to 2^24 px², such as 4096 "
                      "× 4096; beyond, integers take over and the set-up says so."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "The assignment's increments with ΔR computed once from the plane through "
                      "the three vertices, so that slivers cannot blow it up."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Walks the rows between two edges, the largest y first, with ΔR computed "
                      "once from the plane "
                      "through the three vertices, so that short rows cannot blow it up."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Evaluates every edge from its end point that is smaller in (x, y) order and "
                      "flips the sign, so that the two triangles of a shared edge see the same "
                      "number in any arithmetic; in exact arithmetic all are integers."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Evaluates each edge function from one of its vertices, so that the products "
                      "stay small far from the origin; in float64 they are exact up to 2^15 px."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Interpolates along both edges and then along the column, each by adding a "
                      "rate; what is covered is exact."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Interpolates along the left and the right edge and then along the row, each "
                      "by adding a rate; what is covered is exact."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Evaluates v = a·x + b·y + c of the plane through the three values at each "
                      "sample; what is covered is exact."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Weights the three vertices' values with α, β and γ at each sample; what is "
                      "covered is exact."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Walks along the longer side and adds the slope at each step; the pixel is "
                      "the nearest one."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Computes y = m·x + b for each column and rounds it by (int)(y + ½): steep "
                      "lines have gaps, vertical ones no m."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Computes P(t) = P₀ + t·(P₁ − P₀) for t in steps of one pixel of the longer "
                      "side, or less, and writes the pixel nearest to each point."),
    QT_TRANSLATE_NOOP(
        "pixelplumb::MethodSummary",
        "Steps from the end of smaller x (of a steep line, of smaller y) by the sign of an "
        "integer; p_k < 0 stays, so that a tie steps across."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Bresenham's decisions from any lattice point to any other, ties to the "
                      "pixel of larger y or x whether the line rises or falls."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Steps through an octant by the sign of F at midpoints, a whole number "
                      "of quarters, and mirrors each pixel into the other seven; "
                      "of unequal radii through two arcs of a quarter, each into three."),
    QT_TRANSLATE_NOOP(
        "pixelplumb::MethodSummary",
        "Computes y = ±√(r² − x²) for each column; there are gaps where the curve is steep."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Goes round in steps of one pixel of arc and writes the pixel nearest to "
                      "each point (r cos θ, r sin θ)."),
    QT_TRANSLATE_NOOP(
        "pixelplumb::MethodSummary",
        "On each row, writes the samples between the two places where the row meets the curve."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Halves the curve by de Casteljau's algorithm until each piece has no pixels "
                      "but those of its two ends, and writes these: thin as a line, the pixels "
                      "nearer than ½ px by |Δx| + |Δy|."),
    QT_TRANSLATE_NOOP(
        "pixelplumb::MethodSummary",
        "Closes a path of Bézier pieces, takes each as a chain of chords, and fills these by "
        "parity or winding number; the truth is that of the curves themselves."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Takes a line as the rectangle one pixel wide, a curve as a strip of "
                      "quadrilaterals, and blends it by the area that it has of each pixel, "
                      "equally bright in every direction, or by 4 or 16 samples, as the scene's "
                      "antialiasing asks. Where it asks for none, one sample decides a pixel: "
                      "stairs."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Intersects each row with the active edges, sorts the crossings in x, and "
                      "fills by their parity or winding number."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Breaks a convex polygon into the triangles that its first vertex makes with "
                      "its edges, and fills each row by row."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Breaks a polygon that does not cross itself into the triangles of its "
                      "constrained Delaunay triangulation, and fills each row by row."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Breaks any polygon into triangles, also one that crosses itself: crossings "
                      "become vertices, moved to the nearest multiple of 1/256 px, by which a "
                      "sample beside an edge may change its side."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Draws each edge as a line by Bresenham's decisions between any two points "
                      "of the lattice; a pixel in which two edges meet is written by both."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Writes the colour of each point to the address addr = y·width + x, counted "
                      "from the frame's first pixel."),
    QT_TRANSLATE_NOOP("pixelplumb::MethodSummary",
                      "Takes the outlines of the glyphs from a font and fills them as one polygon "
                      "by winding number."),
};

} // namespace

QString methodSummary(const Method &method)
{
    return QCoreApplication::translate(context, method.summary.toUtf8().constData());
}

} // namespace pixelplumb
