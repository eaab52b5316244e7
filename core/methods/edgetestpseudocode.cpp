// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/pseudocode.h"

namespace pixelplumb {

namespace {

/// How the numbers of an edge are found.
QString linesText(const EdgeTestForm &form)
{
    if (form.inside == InsideTest::Cramer)
        return QStringLiteral("D ← x_AC·y_BC − x_BC·y_AC, the determinant");
    const QString edges
        = form.isBarycentric() ? QStringLiteral("f_bc, f_ca, f_ab") : QStringLiteral("E₀, E₁, E₂");
    switch (form.line) {
    case LineForm::Absolute:
    case LineForm::CommonVertex:
        break;
    case LineForm::Solved:
        return edges + QStringLiteral(": A and B solved from the two ends of the edge, C = −1");
    case LineForm::CanonicalEnd:
        return edges + QStringLiteral(": a and b counted from the end that is smaller in (x, y)");
    case LineForm::FirstEnd:
        return edges + QStringLiteral(": a and b counted from the first end of the edge");
    }
    return edges + QStringLiteral(": a, b, c from the two ends of the edge");
}

QString testText(const EdgeTestForm &form)
{
    switch (form.inside) {
    case InsideTest::Signs:
        return QStringLiteral("if E₀, E₁ and E₂ are > 0, or 0 where the fill rule takes the edge:");
    case InsideTest::UnitInterval:
        return QStringLiteral("if α, β and γ are within [0, 1], 0 where the fill rule takes the "
                              "edge:");
    case InsideTest::NonNegative:
        return QStringLiteral("if α, β and γ are > 0, or 0 where the fill rule takes the edge:");
    case InsideTest::Cramer:
        break;
    }
    return QStringLiteral("if u > 0, v > 0 and u + v < 1, or equal where the fill rule takes the "
                          "edge:");
}

QString valuesText(const EdgeTestForm &form)
{
    if (form.inside == InsideTest::Signs)
        return QStringLiteral("E₀, E₁, E₂ ← at (x, y)");
    if (form.inside == InsideTest::Cramer)
        return QStringLiteral("u, v ← by two determinants over D; w ← 1 − u − v");
    return QStringLiteral("α ← f_bc(x, y)/f_bc(a), β ← f_ca(x, y)/f_ca(b), γ ← f_ab(x, y)/f_ab(c)");
}

QString incrementsText(const EdgeTestForm &form)
{
    return form.isBarycentric()
        ? QStringLiteral("add to α, β, γ, R, G and B what a step along %1 adds")
        : QStringLiteral("add to E₀, E₁ and E₂ what a step along %1 adds");
}

QString colourText(const EdgeTestForm &form)
{
    if (form.inside == InsideTest::Cramer)
        return QStringLiteral("R ← u·R_A + v·R_B + w·R_C; G and B likewise");
    if (!form.isBarycentric())
        return QStringLiteral("R ← E₀/F₀·R₂ + E₁/F₁·R₀ + E₂/F₂·R₁; G and B likewise");
    return QStringLiteral("R ← α·R_a + β·R_b + γ·R_c; G and B likewise");
}

} // namespace

Pseudocode edgeTestPseudocode(const EdgeTestForm &form)
{
    using enum Moment;
    const bool isRow = form.order == LoopOrder::RowByRow;
    const bool isIncremental = form.evaluation == Evaluation::Increments;
    const QString along = isRow ? QStringLiteral("x") : QStringLiteral("y");
    const QString across = isRow ? QStringLiteral("y") : QStringLiteral("x");
    Pseudocode code = {{0, linesText(form), {SetUp}}};
    if (form.inside == InsideTest::Signs)
        code.push_back(
            {0,
             QStringLiteral("F₁, F₂, F₀ ← E₁, E₂, E₀ at P₀, P₁, P₂, the vertex opposite; where "
                            "negative, flip E and F"),
             {SetUp}});
    if (form.visited == VisitedSamples::Frame)
        code.push_back({0, QStringLiteral("box ← the whole frame"), {SetUp}});
    else
        code.push_back({0,
                        QStringLiteral("box ← from the smallest to the largest x and y of the "
                                       "vertices, clipped to the frame"),
                        {SetUp},
                        {},
                        {{VariantSet().with(Variant::RoundedBox),
                          QStringLiteral("box ← from (int)(x_min + ½) to (int)(x_max − ½), y "
                                         "likewise, clipped to the frame")}}});
    code.push_back({0, QStringLiteral("if no sample is to be drawn: done"), {Rejected}});
    if (isIncremental)
        code.push_back(
            {0, valuesText(form) + QStringLiteral(" of the box's first sample"), {Begin}});
    code.push_back({0, QStringLiteral("for each %1 of the box:").arg(across), {Begin, Span}});
    if (isIncremental)
        code.push_back({1, incrementsText(form).arg(across), {Span}});
    code.push_back(
        {1, QStringLiteral("for each %1 of the box:").arg(along), {First, Next, Refused}});
    if (!isIncremental)
        code.push_back({2, valuesText(form), {First, Next, Refused}});
    code.push_back({2, testText(form), {First, Next, Refused}});
    if (!(isIncremental && form.isBarycentric()))
        code.push_back({3, colourText(form), {First, Next}});
    code.push_back({3, QStringLiteral("pixel (x, y) ← the bytes of R, G, B"), {First, Next}});
    if (isIncremental)
        code.push_back({2, incrementsText(form).arg(along), {First, Next, Refused}});
    return code;
}

} // namespace pixelplumb
