// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/walklisting.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

using enum Moment;

/// Where the vertices have one colour, rounding must not change it.
QString oneColourText() { return "R₀ = R₁ = R₂ and G₀ = G₁ = G₂ and B₀ = B₁ = B₂"; }

/// What is linear in x and y: each value itself, or the three weights. The vertices are those that
/// are given, and the operations in the kernel's order, so that floats agree, too.
void addCoefficients(WalkListing &listing, InterpolationForm form)
{
    const auto add = [&listing](int depth, const QString &text) {
        listing.add(depth, text, {SetUp}, LineOf::Area);
    };
    if (form == InterpolationForm::Barycentric) {
        add(0,
            "A_α, B_α ← y₂ − y₁, x₁ − x₂; C_α ← −A_α·x₁ − B_α·y₁; k_α ← 1/(A_α·x₀ + B_α·y₀ + "
            "C_α)");
        add(0,
            "A_β, B_β ← y₀ − y₂, x₂ − x₀; C_β ← −A_β·x₂ − B_β·y₂; k_β ← 1/(A_β·x₁ + B_β·y₁ + "
            "C_β)");
        add(0,
            "A_γ, B_γ ← y₁ − y₀, x₀ − x₁; C_γ ← −A_γ·x₀ − B_γ·y₀; k_γ ← 1/(A_γ·x₂ + B_γ·y₂ + "
            "C_γ)");
        add(0,
            "a_α ← k_α·A_α; a_β and a_γ likewise; b_α ← k_α·B_α; b_β and b_γ likewise; c_α ← "
            "k_α·C_α; c_β and c_γ likewise");
        return;
    }
    add(0, "C ← (x₁ − x₀)·(y₂ − y₀) − (y₁ − y₀)·(x₂ − x₀)");
    add(0,
        "for each value v of R, G, B: A_v ← (y₁ − y₀)·(v₂ − v₀) − (v₁ − v₀)·(y₂ − y₀); B_v ← (v₁ − "
        "v₀)·(x₂ − x₀) − (x₁ − x₀)·(v₂ − v₀); D_v ← −(A_v·x₀ + B_v·y₀ + C·v₀)");
    add(0, "for each value v of R, G, B: a_v, b_v, c_v ← −A_v/C, −B_v/C, −D_v/C");
    add(0, u"if %1:"_s.arg(oneColourText()));
    add(1, "for each value v of R, G, B: a_v, b_v, c_v ← 0, 0, v₀");
}

Pseudocode withSamples(Pseudocode code, InterpolationForm form)
{
    const std::vector<Moment> samples = {First, Next};
    const auto add = [&](const QString &text, LineOf of) {
        code.push_back({.depth = 2, .text = text, .moments = samples, .of = of});
    };
    if (form == InterpolationForm::Barycentric) {
        add("α ← a_α·x + b_α·y + c_α; β and γ likewise", LineOf::Area);
        add("R ← α·R₀ + β·R₁ + γ·R₂; G and B likewise", LineOf::Area);
        add(u"if %1: R ← R₀; G and B likewise"_s.arg(oneColourText()), LineOf::Area);
    } else {
        add("for each value v of R, G, B: v ← a_v·x + b_v·y + c_v", LineOf::Area);
    }
    add("R ← R_l + (x − x_l)·((R_r − R_l)/(x_r − x_l)) if x_l < x_r, else R_l + (y − y_l)·((R_r − "
        "R_l)/(y_r − y_l)) if y_l < y_r, else R_l; G and B likewise",
        LineOf::Segment);
    add("pixel (x, y) ← the bytes of R, G, B", LineOf::EveryPrimitive);
    return code;
}

} // namespace

Pseudocode interpolationPseudocode(InterpolationForm form)
{
    if (isBilinear(form))
        return walkPseudocode({.axis = axisOf(form)}, WalkCoverage::Exact);
    WalkListing listing({.rate = ColourRate::Plane}, WalkCoverage::Exact);
    listing.addSorting();
    listing.addSlopes();
    listing.nameSortedVerticesByLetters();
    addCoefficients(listing, form);
    listing.addRejection();
    WalkListing loops({.rate = ColourRate::Plane}, WalkCoverage::Exact);
    loops.addSpans();
    loops.addSamples();
    loops.nameSortedVerticesByLetters();
    Pseudocode code = listing.written();
    std::ranges::move(loops.written(), std::back_inserter(code));
    return withSamples(std::move(code), form);
}

} // namespace pixelplumb
