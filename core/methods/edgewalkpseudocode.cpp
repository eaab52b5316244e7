// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/pseudocode.h"

namespace pixelplumb {

namespace {

Pseudocode accumulatedBounds()
{
    using enum Moment;
    return {{1,
             QStringLiteral("where an edge begins: its {a}, R, G and B in this {span}, from those "
                            "of its vertex"),
             {Begin},
             {},
             {{VariantSet().with(Variant::NoEdgePreStep),
               QStringLiteral("where an edge begins: its {a}, R, G and B ← those of its vertex")}}},
            {1,
             QStringLiteral("else: {a}_{lo} ← {a}_{lo} + m_{lo}, {a}_{hi} ← {a}_{hi} + m_{hi}; R, "
                            "G and B of both likewise"),
             {Span}}};
}

Pseudocode addedColours()
{
    using enum Moment;
    return {{2,
             QStringLiteral("the first: R, G, B ← those at {a}_{lo}, moved on to this sample"),
             {First},
             {},
             {{VariantSet().with(Variant::NoColourPreStep),
               QStringLiteral("the first: R, G, B ← those at {a}_{lo}, as they are")}}},
            {2, QStringLiteral("else: R ← R + ΔR, G ← G + ΔG, B ← B + ΔB"), {Next}},
            {2, QStringLiteral("pixel (x, y) ← the bytes of R, G, B"), {First, Next}}};
}

Pseudocode directColours()
{
    using enum Moment;
    return {{2,
             QStringLiteral("R ← of the plane, from P₀: R₀ + (x − x₀)·∂R/∂x + (y − y₀)·ΔR; G and B "
                            "likewise — on a segment, along it"),
             {First, Next}},
            {2,
             QStringLiteral("pixel (x, y) ← ⌊R + (½ + β_C)⌋; G and B likewise — β_C: so that no "
                            "rounding takes a half away; without ½ where levels are truncated"),
             {First, Next}}};
}

} // namespace

Pseudocode edgeWalkPseudocode(const EdgeWalkForm &form)
{
    using enum Moment;
    const bool isDirect = form.walk == WalkForm::Direct;
    const QString sorted = form.axis == SpanAxis::Row
        ? QStringLiteral("sort the vertices by y, the largest first: P₀, P₁, P₂")
        : QStringLiteral("sort the vertices by x: P₀, P₁, P₂");
    const QString added
        = QStringLiteral("m and δR, δG, δB ← what each {span} adds along L₀₁, L₁₂ and L₀₂");
    const VariantSet bothDivisors
        = VariantSet().with(Variant::DivisorPlusOne).with(Variant::DivisorMinusOne);
    const auto divided = [](Variant variant, QChar sign) {
        return VariedLine{VariantSet().with(variant),
                          QStringLiteral("m and δR, δG, δB ← the differences along L₀₁, L₁₂ and "
                                         "L₀₂ over (their {span}s %1 1)")
                              .arg(sign)};
    };
    Pseudocode code = {{0,
                        sorted,
                        {SetUp},
                        {},
                        {{VariantSet().with(Variant::UnsortedColours),
                          sorted + QStringLiteral("; R, G, B stay in the order given")}}},
                       {0,
                        added,
                        {SetUp},
                        {},
                        {divided(Variant::DivisorPlusOne, u'+'),
                         divided(Variant::DivisorMinusOne, u'−'),
                         {bothDivisors, added}}}};
    if (form.rate == ColourRate::Plane)
        code.push_back(
            {0, QStringLiteral("ΔR, ΔG, ΔB ← of the plane through the three vertices"), {SetUp}});
    code.push_back({0, QStringLiteral("if no sample is to be drawn: done"), {Rejected}});
    code.push_back(
        {0,
         QStringLiteral("for each {span} that the fill rule takes, with L₀₁ up to P₁, with L₁₂ "
                        "from there, and L₀₂:"),
         {Begin, Span}});
    if (isDirect)
        code.push_back({1,
                        QStringLiteral("{a}_{lo}, {a}_{hi} ← {a}_i + (x − x_i)·m on their edges"),
                        {Begin, Span}});
    else
        for (const PseudocodeLine &line : accumulatedBounds())
            code.push_back(line);
    if (form.rate == ColourRate::Bilinear)
        code.push_back({1,
                        QStringLiteral("if {a}_{lo} < {a}_{hi}: ΔR ← (R_{hi} − R_{lo})/({a}_{hi} − "
                                       "{a}_{lo}); ΔG and ΔB likewise"),
                        {Begin, Span}});
    code.push_back({1,
                    isDirect ? QStringLiteral("for each {across} between them that the fill rule "
                                              "takes, each bound moved by its β:")
                             : QStringLiteral("for each {across} from {a}_{lo} to {a}_{hi} that "
                                              "the fill rule takes:"),
                    {First, Next}});
    for (const PseudocodeLine &line : isDirect ? directColours() : addedColours())
        code.push_back(line);
    const EdgeWalkNames names(form);
    for (PseudocodeLine &line : code) {
        line.text = names.filled(line.text);
        for (VariedLine &varied : line.varied)
            varied.text = names.filled(varied.text);
    }
    return code;
}

} // namespace pixelplumb
