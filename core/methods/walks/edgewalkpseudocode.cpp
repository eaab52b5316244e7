// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walklisting.h"

namespace pixelplumb {

namespace {

using enum Moment;

/// The change of R in the plane through the vertices; A is a number of the set-up.
QString planeChange(QChar axis) { return planeSlope(axis, "A").replace(u'%', u'R'); }

void addPlane(WalkListing &listing, SpanAxis axis)
{
    listing.add(
        0,
        u"ΔR ← %1; ΔG and ΔB likewise — in the plane through the vertices; A is twice the area"_s
            .arg(planeChange(axis == SpanAxis::Row ? u'x' : u'y')),
        {SetUp}, LineOf::Area);
}

/// The level of a sample on a triangle without area, between the ends of its segment.
QString alongSegment(SpanAxis axis)
{
    const QString along = "R₀ + (x − x₀)·((R₂ − R₀)/(x₂ − x₀)) if x₀ < x₂";
    const QString across = axis == SpanAxis::Row
        ? u"R₀ + (y₀ − y)·((R₂ − R₀)/(y₀ − y₂)) if y₂ < y₀"_s
        : u"R₀ + (y − y₀)·((R₂ − R₀)/(y₂ − y₀)) if y₀ < y₂"_s;
    return u"R ← %1, else %2, else R₀; G and B likewise"_s.arg(
        axis == SpanAxis::Row ? across : along, axis == SpanAxis::Row ? along : across);
}

/// Adds the colours of a span's samples, one after the other; where coverage is exact those of a
/// segment each for itself.
void addColours(WalkListing &listing, SpanAxis axis, WalkCoverage coverage)
{
    const bool isDirect = coverage == WalkCoverage::Exact;
    const LineOf walked = isDirect ? LineOf::Area : LineOf::EveryPrimitive;
    if (isDirect)
        listing.add(2, alongSegment(axis), {First, Next}, LineOf::Segment);
    listing.addVaried(
        2, "the first: R ← R_{lo} + ({a} − {a}_{lo})·ΔR; G and B likewise", {First},
        {{VariantSet().with(Variant::NoColourPreStep),
          "the first: R ← R_{lo} + ({a} − {a}_first)·ΔR; G and B likewise — {a}_first: where the "
          "{across}s begin, in the frame or not"}},
        walked);
    listing.add(2, "else: R ← R + ΔR; G and B likewise", {Next}, walked);
    listing.add(2, "pixel (x, y) ← the bytes of R, G, B", {First, Next});
}

/// Every number from a vertex anew. β is half the distance between the values that y can have, or a
/// quarter of that between levels.
Pseudocode directPseudocode(const EdgeWalkForm &form)
{
    WalkListing listing(form, WalkCoverage::AsComputed);
    listing.addSorting();
    listing.add(0,
                listing.slope({}, {})
                    + u"; β_ij ← 1/(2·256²·(x_j − x_i)) if x_i < x_j, else 1/(2·256)"_s,
                {SetUp});
    listing.add(0,
                "β_C ← 1/(4·256·(x₂ − x₀)) if x₀ < x₂, else 1/(4·256·(y₂ − y₀)) if y₀ < y₂, else 0",
                {SetUp}, LineOf::Segment);
    addPlane(listing, form.axis);
    listing.add(0,
                u"ΔR_x ← %1; ΔG_x and ΔB_x likewise; β_C ← 1/(4·256²·|A|)"_s.arg(planeChange(u'x')),
                {SetUp}, LineOf::Area);
    listing.addRejection();
    listing.addSpans();
    listing.addSamples();
    listing.add(2, "R ← R₀ + (x − x₀)·ΔR_x + (y − y₀)·ΔR; G and B likewise", {First, Next},
                LineOf::Area);
    listing.add(2,
                "R ← R₀ + (R₂ − R₀)·(x − x₀)/(x₂ − x₀) if x₀ < x₂, else R₀ + (R₂ − R₀)·(y − "
                "y₀)/(y₂ − y₀) if y₀ < y₂, else R₀; G and B likewise",
                {First, Next}, LineOf::Segment);
    listing.add(2,
                "pixel (x, y) ← the bytes of R + β_C, G + β_C, B + β_C — β_C: so that no rounding "
                "takes a half away",
                {First, Next});
    return listing.written();
}

} // namespace

Pseudocode walkPseudocode(const EdgeWalkForm &form, WalkCoverage coverage)
{
    if (form.walk == WalkForm::Direct)
        return directPseudocode(form);
    WalkListing listing(form, coverage);
    listing.addSorting();
    listing.addSlopes();
    if (form.rate == ColourRate::Plane)
        addPlane(listing, form.axis);
    listing.addRejection();
    listing.addSpans();
    listing.add(1,
                "ΔR ← (R_{hi} − R_{lo})/({a}_{hi} − {a}_{lo}) if {a}_{lo} ≠ {a}_{hi}, else 0; ΔG "
                "and ΔB likewise",
                listing.everySpan,
                form.rate == ColourRate::Plane        ? LineOf::Segment
                    : coverage == WalkCoverage::Exact ? LineOf::Area
                                                      : LineOf::EveryPrimitive);
    listing.addSamples();
    addColours(listing, form.axis, coverage);
    return listing.written();
}

Pseudocode edgeWalkPseudocode(const EdgeWalkForm &form)
{
    return walkPseudocode(form, WalkCoverage::AsComputed);
}

} // namespace pixelplumb
