// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/coefficientlines.h"
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/walklisting.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

using enum Moment;

/// Where the vertices have one colour, rounding must not change it.
QString oneColourText() { return "R₀ = R₁ = R₂ and G₀ = G₁ = G₂ and B₀ = B₁ = B₂"; }

/// The vertices are those that are given.
void addCoefficients(WalkListing &listing, InterpolationForm form)
{
    const auto add = [&listing](int depth, const QString &text) {
        listing.add(depth, text, {SetUp}, LineOf::Area);
    };
    for (const QString &line : coefficientLines(form, u"each value v of R, G, B"_s))
        add(0, line);
    if (form == InterpolationForm::Plane) {
        add(0, u"if %1:"_s.arg(oneColourText()));
        add(1, "for each value v of R, G, B: a_v, b_v, c_v ← 0, 0, v₀");
    }
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
