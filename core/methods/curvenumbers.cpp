// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curvenumbers.h"

#include "core/methods/formulatext.h"
#include "core/methods/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

NumberDescription number(const char *id, const QString &title, const char *unit,
                         const QString &toolTip, const QString &formula = {},
                         Group group = Group::Span)
{
    return {.id = QString::fromUtf8(id),
            .title = title,
            .unit = QString::fromUtf8(unit),
            .toolTip = toolTip,
            .formula = formula,
            .group = group};
}

NumberDescription counter(const QString &toolTip)
{
    return number("i", QStringLiteral("i"), "", toolTip, {}, Group::Position);
}

/// A decision parameter of the midpoint circle.
Quantity decisionIn(const MidpointStep &step, Int128 number)
{
    return Quantity::rational(number, step.decisionUnit);
}

/// The root of exact numbers is taken down to 1/256 px.
void specifyRoot(NumberDescription &description, const CircleExplicitState &step)
{
    if (step.round.radiusX == 0) {
        description.formula = QStringLiteral("h = r_y");
        return;
    }
    const QString root = step.round.isCircle() ? QStringLiteral("√(r_x² − d²)")
                                               : QStringLiteral("r_y/r_x·√(r_x² − d²)");
    description.formula = step.root.isRational() ? QStringLiteral("h = ⌊256·%1⌋/256").arg(root)
                                                 : QStringLiteral("h = ") + root;
}

/// % stands for the radius along the arc, # for the one across.
QString ofArc(QString formula, const MidpointStep &step)
{
    const bool isFlat = step.arc == 0;
    return formula.replace(u'%', isFlat ? QStringLiteral("r_x") : QStringLiteral("r_y"))
        .replace(u'#', isFlat ? QStringLiteral("r_y") : QStringLiteral("r_x"));
}

void specifyNextMidpoint(NumberDescription &description, const MidpointStep &step)
{
    if (step.hasDecision)
        return;
    if (step.arc == 0 && step.x == 0)
        description.formula = QStringLiteral("p_k₊₁ = p₀");
    else if (step.isScaled())
        description.formula = QStringLiteral("p_k₊₁ = (x_k + 1)² + (y_k − ½)² − r_x²");
    else
        description.formula
            = ofArc(QStringLiteral("p_k₊₁ = #²·(x_k + 1)² + %²·(y_k − ½)² − %²·#²"), step);
}

/// By the branch that was taken: the row stays, goes one down or, where the arc is steep, several.
void specifyMidpointIncrement(NumberDescription &description, const MidpointStep &step)
{
    const QString along
        = step.isScaled() ? QStringLiteral("2·x_k + 1") : QStringLiteral("#²·(2·x_k + 1)");
    const QString scale = step.isScaled() ? QString() : QStringLiteral("%²·");
    const QString across = step.down == 0 ? QString()
        : step.down == 1
        ? QStringLiteral(" − 2·") + scale + QStringLiteral("y_k")
        : QStringLiteral(" − ") + scale + QStringLiteral("(y_k′·(y_k′ − 1) − y_k·(y_k − 1))");
    description.formula = ofArc(QStringLiteral("Δp = ") + along + across, step);
}

} // namespace

const NumberTable<PointSetUp> &pointSetUpNumbers()
{
    static const NumberTable<PointSetUp> numbers
        = {{number("width", QStringLiteral("width"), "px",
                   QStringLiteral("Pixels in a row of the frame.")),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.width); }},
           {number("x_0", QStringLiteral("x₀"), "px", QStringLiteral("The frame's first column.")),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.firstColumn); }},
           {number("y_0", QStringLiteral("y₀"), "px", QStringLiteral("The frame's first row.")),
            [](const PointSetUp &setUp) { return Quantity::integer(setUp.firstRow); }}};
    return numbers;
}

const NumberTable<PointStep> &pointNumbers()
{
    static const NumberTable<PointStep> numbers
        = {{counter(QStringLiteral("The point's number, from 0.")),
            [](const PointStep &step) { return Quantity::integer(step.number); }},
           {pixelX(), [](const PointStep &step) { return Quantity::integer(step.x); }},
           {pixelY(), [](const PointStep &step) { return Quantity::integer(step.y); }},
           {number("addr", QStringLiteral("addr"), "px",
                   QStringLiteral("The pixel's address in the frame, counted in pixels from its "
                                  "first one; none outside the frame."),
                   QStringLiteral("addr = (y − y₀)·width + (x − x₀)"), Group::Decision),
            [](const PointStep &step) {
                return step.isInFrame ? Quantity::integer(step.address) : Quantity();
            }}};
    return numbers;
}

const NumberTable<Round> &roundSetUpNumbers()
{
    static const NumberTable<Round> numbers
        = {{number("x_c", QStringLiteral("x_c"), "px",
                   QStringLiteral("The centre's x, from the centre of pixel (0, 0).")),
            [](const Round &round) { return pixels(round.centre.x); }},
           {number("y_c", QStringLiteral("y_c"), "px",
                   QStringLiteral("The centre's y, from the centre of pixel (0, 0).")),
            [](const Round &round) { return pixels(round.centre.y); }},
           {number("r_x", QStringLiteral("r_x"), "px",
                   QStringLiteral("The radius along x: r of a circle, a of an ellipse.")),
            [](const Round &round) { return pixels(round.radiusX); }},
           {number("r_y", QStringLiteral("r_y"), "px",
                   QStringLiteral("The radius along y: r of a circle, b of an ellipse.")),
            [](const Round &round) { return pixels(round.radiusY); }}};
    return numbers;
}

const NumberTable<CircleFillRow> &circleFillNumbers()
{
    static const NumberTable<CircleFillRow> numbers = {
        {number("y", QStringLiteral("y"), "px", QStringLiteral("The row."), {}, Group::Position),
         [](const CircleFillRow &row) { return Quantity::integer(row.y); }},
        {number("x_L", QStringLiteral("x_L"), "px",
                QStringLiteral("Where the row meets the curve on the left, up to the next "
                               "1/256 px: the first lattice point inside.")),
         [](const CircleFillRow &row) { return pixels(row.left); }},
        {number("x_R", QStringLiteral("x_R"), "px",
                QStringLiteral("Where the row meets the curve on the right, down to the next "
                               "1/256 px: the last lattice point inside.")),
         [](const CircleFillRow &row) { return pixels(row.right); }},
        {number("first", QStringLiteral("x_first"), "px",
                QStringLiteral("The first covered column."), QStringLiteral("x_first = ⌈x_L⌉"),
                Group::Span),
         [](const CircleFillRow &row) { return Quantity::integer(row.firstSample); }},
        {number("last", QStringLiteral("x_last"), "px", QStringLiteral("The last covered column."),
                QStringLiteral("x_last = ⌊x_R⌋"), Group::Span),
         [](const CircleFillRow &row) { return Quantity::integer(row.endSample - 1); }}};
    return numbers;
}

const NumberTable<CircleExplicitState> &circleExplicitNumbers()
{
    static const NumberTable<CircleExplicitState> numbers = {
        {scannedNumber(),
         [](const CircleExplicitState &step) { return Quantity::integer(step.x); }},
        {number("d", QStringLiteral("d"), "px", QStringLiteral("The column from the centre."),
                QStringLiteral("d = x − x_c")),
         [](const CircleExplicitState &step) { return pixels(step.distance); }},
        {number("h", QStringLiteral("h"), "px",
                QStringLiteral("√(r² − d²); of unequal radii, (b/a)·√(a² − d²). Exact arithmetic "
                               "has no root: it takes the root down to 1/256 px, which decides "
                               "every rounding as the root itself would."),
                QStringLiteral("h = r_y/r_x·√(r_x² − d²)"), Group::Decision),
         [](const CircleExplicitState &step) { return step.root; }, specifyRoot},
        {number("y_above", QStringLiteral("y_T"), "px",
                QStringLiteral("The pixel of larger y, to the nearest row."),
                QStringLiteral("y_T = ⌊y_c + h + ½⌋"), Group::Span),
         [](const CircleExplicitState &step) { return Quantity::integer(step.above); }},
        {number("y_below", QStringLiteral("y_B"), "px",
                QStringLiteral("The pixel of smaller y, to the nearest row."),
                QStringLiteral("y_B = ⌈y_c − h − ½⌉"), Group::Span),
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
            {number("delta_theta", QStringLiteral("Δθ"), "rad",
                    QStringLiteral("The step of the angle: one over the radius (the "
                                   "larger one), one pixel of arc."),
                    QStringLiteral("Δθ = 1/max(r_x, r_y)")),
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
        = {{counter(QStringLiteral("The step's number, from 0 at θ = 0.")),
            [](const CircleParametricState &step) { return Quantity::integer(step.number); }},
           {number("theta", QStringLiteral("θ"), "rad", QStringLiteral("The angle."),
                   QStringLiteral("θ = i·Δθ"), Group::Decision),
            [](const CircleParametricState &step) { return step.angle; }},
           {number("u", QStringLiteral("u"), "px", QStringLiteral("The point's x."),
                   QStringLiteral("u = x_c + r_x·cos θ"), Group::Decision),
            [](const CircleParametricState &step) { return step.curveX; }},
           {number("v", QStringLiteral("v"), "px", QStringLiteral("The point's y."),
                   QStringLiteral("v = y_c + r_y·sin θ"), Group::Decision),
            [](const CircleParametricState &step) { return step.curveY; }},
           {number("x", QStringLiteral("x"), "px", QStringLiteral("The nearest pixel's x."),
                   QStringLiteral("x = ⌊u + ½⌋"), Group::Span),
            [](const CircleParametricState &step) { return Quantity::integer(step.x); }},
           {number("y", QStringLiteral("y"), "px", QStringLiteral("The nearest pixel's y."),
                   QStringLiteral("y = ⌊v + ½⌋"), Group::Span),
            [](const CircleParametricState &step) { return Quantity::integer(step.y); }}};
    return numbers;
}

const NumberTable<MidpointSetUp> &midpointSetUpNumbers()
{
    static const auto numbers = [] {
        const auto toolTip = [](const QString &function) {
            return QStringLiteral(
                       "F(x, y) = %1 at the first midpoint, (1, r_y − ½) from the centre.")
                .arg(function);
        };
        const QString ofEqualRadii = QStringLiteral("x² + y² − r_x²");
        const QString ofOthers = QStringLiteral("r_y²·x² + r_x²·y² − r_x²·r_y²");
        NumberTable<MidpointSetUp> table;
        for (const NumberRow<Round> &row : roundSetUpNumbers())
            table.push_back(
                {row.description, [read = row.read](const MidpointSetUp &setUp) {
                     return read({{setUp.centre.x * unitsPerPixel, setUp.centre.y * unitsPerPixel},
                                  setUp.radiusX * unitsPerPixel,
                                  setUp.radiusY * unitsPerPixel});
                 }});
        table.push_back(
            {number("p_0", QStringLiteral("p₀"), "",
                    toolTip(ofOthers + QStringLiteral(", of equal radii ") + ofEqualRadii + u','),
                    QStringLiteral("p₀ = r_y² − r_x²·r_y + r_x²/4"), Group::Decision),
             [](const MidpointSetUp &setUp) {
                 const MidpointStep first = midpointStepAt(setUp.arc(0), 0, 0);
                 return decisionIn(first, first.nextDecision);
             },
             [=](NumberDescription &description, const MidpointSetUp &setUp) {
                 const bool hasEqualRadii = setUp.isCircle() && setUp.radiusX != 0;
                 description.toolTip = toolTip(hasEqualRadii ? ofEqualRadii : ofOthers);
                 if (hasEqualRadii)
                     description.formula = QStringLiteral("p₀ = 5/4 − r_x");
             }});
        return table;
    }();
    return numbers;
}

const NumberTable<MidpointStep> &circleMidpointNumbers()
{
    const NumberDescription decision = number(
        "p_k", QStringLiteral("p_k"), "",
        QStringLiteral("F at the midpoint between y_k and the one inwards: positive outside, "
                       "so that the inner one is nearer."),
        QStringLiteral("p_k ← p_k₊₁′"), Group::Decision);
    const NumberDescription next
        = number("p_next", QStringLiteral("p_k₊₁"), "", QStringLiteral("F at the next midpoint."),
                 QStringLiteral("p_k₊₁ = p_k + Δp"), Group::Decision);
    static const NumberTable<MidpointStep> numbers = {
        {number("arc", QStringLiteral("arc"), "",
                QStringLiteral("1: x_k along x, of equal radii mirrored into all octants; 2: "
                               "x_k along y."),
                {}, Group::Position),
         [](const MidpointStep &step) { return Quantity::integer(step.arc + 1); }},
        {decision,
         [](const MidpointStep &step) {
             return step.hasDecision ? decisionIn(step, step.decision) : Quantity();
         }},
        {number("x_k", QStringLiteral("x_k"), "px",
                QStringLiteral("From the centre along the arc."), {}, Group::Position),
         [](const MidpointStep &step) { return Quantity::integer(step.x); }},
        {number("y_k", QStringLiteral("y_k"), "px",
                QStringLiteral("From the centre across the arc.")),
         [](const MidpointStep &step) { return Quantity::integer(step.y); }},
        {number("increment", QStringLiteral("Δp"), "",
                QStringLiteral("2x_k + 1 where y_k stays, less 2y_k where it goes one inwards; of "
                               "unequal radii times their squares.")),
         [](const MidpointStep &step) {
             return step.hasDecision ? decisionIn(step, step.nextDecision - step.decision)
                                     : Quantity();
         },
         specifyMidpointIncrement},
        {next, [](const MidpointStep &step) { return decisionIn(step, step.nextDecision); },
         specifyNextMidpoint}};
    return numbers;
}

} // namespace pixelplumb
