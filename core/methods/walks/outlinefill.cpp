// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/outlinefill.h"

#include "core/methods/methodrows.h"

namespace pixelplumb {

Method outlineFillMethod()
{
    Method method = methodOf<OutlineFillKernel>();
    method.id = "midpoint-outline-fill";
    method.title = QT_TRANSLATE_NOOP("core", "Midpoint outline, filled");
    method.source = "Triangles slides, “Use Midpoint Algorithm for edges and fill in?”; "
                    "Rasterization slides, “Bresenham's Line Algorithm”";
    method.pseudocode = {
        {0, "x₀, y₀ ← ⌊x₀ + ½⌋, ⌊y₀ + ½⌋; x₁ and x₂ likewise — on whole pixels", {Moment::SetUp}},
        {0, "for each edge L_ij of L₀₁, L₁₂, L₂₀:", {Moment::SetUp}},
        {1, "t ← 1 if |y_j − y_i| ≥ |x_j − x_i|, else 0 — 1 where it is steep", {Moment::SetUp}},
        {1, "if x_j < x_i and t = 0, or y_j < y_i and t = 1: exchange i and j", {Moment::SetUp}},
        {1,
         "Δ, δ ← |y_j − y_i|, |x_j − x_i| if t = 1, else |x_j − x_i|, |y_j − y_i|",
         {Moment::SetUp}},
        {1, "s ← −1 if x_j < x_i and t = 1, or y_j < y_i and t = 0, else 1", {Moment::SetUp}},
        {1, "for each n from 0 to Δ:", {Moment::SetUp}},
        {2, "the first: a, p ← 0, 2δ − Δ", {Moment::SetUp}},
        {2, "else if p < 0: p ← p + 2δ", {Moment::SetUp}},
        {2, "else: a ← a + 1; p ← p + 2δ − 2Δ", {Moment::SetUp}},
        {2,
         "x, y ← x_i + s·a, y_i + n if t = 1, else x_i + n, y_i + s·a — a pixel of the outline",
         {Moment::SetUp}},
        {2, "R ← R_i + n·(R_j − R_i)/Δ if Δ > 0, else R_i; G and B likewise", {Moment::SetUp}},
        {2,
         "where it begins: y_low[x], y_high[x] ← y, y; R_low[x], R_high[x] ← R, R; G_low[x] and "
         "B_low[x] likewise",
         {Moment::SetUp}},
        {2,
         "if y < y_low[x]: y_low[x] ← y; R_low[x] ← R; G_low[x] and B_low[x] likewise",
         {Moment::SetUp}},
        {2,
         "if y > y_high[x]: y_high[x] ← y; R_high[x] ← R; G_high[x] and B_high[x] likewise",
         {Moment::SetUp}},
        {0, "if no sample is to be drawn: done", {Moment::Rejected}},
        {0, "for each column x of the outline:", {Moment::Begin, Moment::Span}},
        {1,
         "ΔR ← (R_high[x] − R_low[x])/(y_high[x] − y_low[x]) if y_low[x] < y_high[x], else 0; ΔG "
         "and ΔB likewise",
         {Moment::Begin, Moment::Span}},
        {1,
         "for each row y of the frame from y_low[x] to y_high[x]:",
         {Moment::First, Moment::Next}},
        {2, "the first: R ← R_low[x] + (y − y_low[x])·ΔR; G and B likewise", {Moment::First}},
        {2, "else: R ← R + ΔR; G and B likewise", {Moment::Next}},
        {2, "pixel (x, y) ← the bytes of R, G, B", {Moment::First, Moment::Next}}};
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Draws the three edges as lines of whole pixels and fills each column from the smallest to "
        "the largest y of them: pixels nearest to an edge are painted on whichever side of it they "
        "lie, those of a shared edge twice.");
    method.remarks += u"whole-pixel vertices"_s;
    method.roundsPoints = true;
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason
        = "the pixels of the outline are painted whatever side of the edge they lie on";
    return method;
}

} // namespace pixelplumb
