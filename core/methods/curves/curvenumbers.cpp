// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/curvenumbers.h"

#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

NumberDescription counter(const QString &toolTip) { return plainNumber("i", "i", {}, toolTip); }

/// The exact root is rounded down to 1/256 px.
void specifyRoot(NumberDescription &description, const CircleExplicitState &step)
{
    if (step.round.radiusX == 0) {
        description.formula = "h = r_y";
        return;
    }
    const QString root = step.round.isCircle() ? u"√(r_x² − d²)"_s : u"r_y/r_x·√(r_x² − d²)"_s;
    description.formula
        = step.root.isRational() ? u"h = ⌊256·%1⌋/256"_s.arg(root) : u"h = "_s + root;
}

} // namespace

const NumberTable<PointSetUp> &pointSetUpNumbers()
{
    static const NumberTable<PointSetUp> numbers
        = {{plainNumber("width", "width", "px", "Pixels in a row of the frame.", {}, Group::Span),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.width); }},
           {plainNumber("x_0", "x₀", "px", "The frame's first column.", {}, Group::Span),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.firstColumn); }},
           {plainNumber("y_0", "y₀", "px", "The frame's first row.", {}, Group::Span),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.firstRow); }}};
    return numbers;
}

const NumberTable<PointStep> &pointNumbers()
{
    static const NumberTable<PointStep> numbers
        = {{counter("The point's number, from 0."),
            [](const PointStep &step) { return Quantity::integer(step.number); }},
           {pixelX(), [](const PointStep &step) { return Quantity::integer(step.x); }},
           {pixelY(), [](const PointStep &step) { return Quantity::integer(step.y); }},
           {plainNumber("addr", "addr", "px",
                        "The pixel's address in the frame, counted in pixels from its first one; "
                        "none outside the frame.",
                        "addr = (y − y₀)·width + (x − x₀)", Group::Decision),
            [](const PointStep &step) {
                return step.isInFrame ? Quantity::integer(step.address) : Quantity();
            }}};
    return numbers;
}

const NumberTable<Round> &roundSetUpNumbers()
{
    static const NumberTable<Round> numbers
        = {{plainNumber("x_c", "x_c", "px", "The centre's x, from the centre of pixel (0, 0).", {},
                        Group::Span),
            [](const Round &round) { return pixels(round.centre.x); }},
           {plainNumber("y_c", "y_c", "px", "The centre's y, from the centre of pixel (0, 0).", {},
                        Group::Span),
            [](const Round &round) { return pixels(round.centre.y); }},
           {plainNumber("r_x", "r_x", "px", "The radius along x: r of a circle, a of an ellipse.",
                        {}, Group::Span),
            [](const Round &round) { return pixels(round.radiusX); }},
           {plainNumber("r_y", "r_y", "px", "The radius along y: r of a circle, b of an ellipse.",
                        {}, Group::Span),
            [](const Round &round) { return pixels(round.radiusY); }}};
    return numbers;
}

namespace {

/// Half of the row's chord, to one side of the centre; `sign` is that of the side.
void specifyChordEnd(NumberDescription &description, const CircleFillState &state, QChar sign)
{
    const QString root = "√(r_y² − (y − y_c)²)";
    const QString half = state.round.isCircle() ? root : u"r_x/r_y·"_s + root;
    description.formula = description.title + u" = x_c "_s + sign
        + (state.round.radiusY == 0 ? u" r_x"_s : u" ⌊256·%1⌋/256"_s.arg(half));
}

} // namespace

const NumberTable<CircleFillState> &circleFillNumbers()
{
    using State = CircleFillState;
    static const NumberTable<State> numbers
        = {{plainNumber("y", "y", "px", "The row."),
            [](const State &state) { return Quantity::integer(state.row.y); }},
           {plainNumber("x_L", "x_L", "px",
                        "Where the row meets the curve on the left, up to the next 1/256 px: the "
                        "first lattice point inside.",
                        {}, Group::Span),
            [](const State &state) { return pixels(state.row.left); },
            [](NumberDescription &description, const State &state) {
                specifyChordEnd(description, state, u'−');
            }},
           {plainNumber("x_R", "x_R", "px",
                        "Where the row meets the curve on the right, down to the next 1/256 px: "
                        "the last lattice point inside.",
                        {}, Group::Span),
            [](const State &state) { return pixels(state.row.right); },
            [](NumberDescription &description, const State &state) {
                specifyChordEnd(description, state, u'+');
            }},
           {plainNumber("first", "x_first", "px", "The first covered column.", "x_first = ⌈x_L⌉",
                        Group::Span),
            [](const State &state) { return Quantity::integer(state.row.firstSample); }},
           {plainNumber("last", "x_last", "px", "The last covered column.", "x_last = ⌊x_R⌋",
                        Group::Span),
            [](const State &state) { return Quantity::integer(state.row.endSample - 1); }}};
    return numbers;
}

const NumberTable<CircleExplicitState> &circleExplicitNumbers()
{
    static const NumberTable<CircleExplicitState> numbers
        = {{scannedNumber(),
            [](const CircleExplicitState &step) { return Quantity::integer(step.x); }},
           {plainNumber("d", "d", "px", "The column from the centre.", "d = x − x_c", Group::Span),
            [](const CircleExplicitState &step) { return pixels(step.distance); }},
           {plainNumber("h", "h", "px",
                        "√(r² − d²); of unequal radii, (b/a)·√(a² − d²). Exact arithmetic has no "
                        "root: it takes the root down to 1/256 px, which decides every rounding as "
                        "the root itself would.",
                        "h = r_y/r_x·√(r_x² − d²)", Group::Decision),
            [](const CircleExplicitState &step) { return step.root; }, specifyRoot},
           {plainNumber("y_above", "y_T", "px", "The pixel of larger y, to the nearest row.",
                        "y_T = ⌊y_c + h + ½⌋", Group::Span),
            [](const CircleExplicitState &step) { return Quantity::integer(step.above); }},
           {plainNumber("y_below", "y_B", "px", "The pixel of smaller y, to the nearest row.",
                        "y_B = ⌈y_c − h − ½⌉", Group::Span),
            [](const CircleExplicitState &step) { return Quantity::integer(step.below); }}};
    return numbers;
}

const NumberTable<CircleParametricSetUpState> &circleParametricSetUpNumbers()
{
    static const auto numbers = [] {
        NumberTable<CircleParametricSetUpState> table;
        for (const NumberRow<Round> &row : roundSetUpNumbers())
            table.push_back(
                {row.description, [read = row.read](const CircleParametricSetUpState &setUp) {
                     return read(setUp.round);
                 }});
        table.push_back(
            {plainNumber(
                 "delta_theta", "Δθ", "rad",
                 "The step of the angle: one over the radius (the larger one), one pixel of arc.",
                 "Δθ = 1/max(r_x, r_y)", Group::Span),
             [](const CircleParametricSetUpState &setUp) { return setUp.angleStep; },
             [](NumberDescription &description, const CircleParametricSetUpState &setUp) {
                 if (setUp.angleStep.toDouble() == 0)
                     description.formula.clear();
             }});
        return table;
    }();
    return numbers;
}

const NumberTable<CircleParametricState> &circleParametricNumbers()
{
    static const NumberTable<CircleParametricState> numbers
        = {{counter("The step's number, from 0 at θ = 0."),
            [](const CircleParametricState &step) { return Quantity::integer(step.number); }},
           {plainNumber("theta", "θ", "rad", "The angle.", "θ = i·Δθ", Group::Decision),
            [](const CircleParametricState &step) { return step.angle; }},
           {plainNumber("u", "u", "px", "The point's x.", "u = x_c + r_x·cos θ", Group::Decision),
            [](const CircleParametricState &step) { return step.curveX; }},
           {plainNumber("v", "v", "px", "The point's y.", "v = y_c + r_y·sin θ", Group::Decision),
            [](const CircleParametricState &step) { return step.curveY; }},
           {plainNumber("x", "x", "px", "The nearest pixel's x.", "x = ⌊u + ½⌋", Group::Span),
            [](const CircleParametricState &step) { return Quantity::integer(step.x); }},
           {plainNumber("y", "y", "px", "The nearest pixel's y.", "y = ⌊v + ½⌋", Group::Span),
            [](const CircleParametricState &step) { return Quantity::integer(step.y); }}};
    return numbers;
}

} // namespace pixelplumb
