// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/refusaltext.h"

#include "core/methods/words/formulatext.h"
#include "core/runs/explain/edgename.h"
#include "core/runs/explain/segmenttext.h"
#include "core/scan/choicenames.h"
#include "core/scan/tests/edgeline.h"
#include "core/trace/namednumbers.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

oracle::SampleVerdict verdictOn(const Triangle &triangle, const TracedScene &traced, std::int64_t x,
                                std::int64_t y)
{
    return oracle::judge(triangle, boundaryRuleOf(traced.scene), x, y);
}

/// The triangle rotated by half a turn about the middle of an edge: it shares the edge, with its
/// inside on the other side.
Triangle acrossEdge(const Triangle &triangle, const oracle::EdgeVerdict &edge)
{
    Triangle turned = triangle;
    const auto from = std::size_t(edge.from);
    const auto to = std::size_t(edge.to);
    std::swap(turned.vertices[from], turned.vertices[to]);
    LatticePoint &opposite = turned.vertices[3 - from - to].position;
    const LatticePoint &a = triangle.vertices[from].position;
    const LatticePoint &b = triangle.vertices[to].position;
    opposite = {a.x + b.x - opposite.x, a.y + b.y - opposite.y};
    return turned;
}

/// The function a·x + b·y + c of the edge at a point, as the slides write it: f_bc.
Quantity edgeFunctionAt(const LatticePoint &from, const LatticePoint &to, const LatticePoint &point)
{
    return Quantity::rational(-doubledArea(from, to, point), squareUnitsPerPixel);
}

/// Whether the method's set-up has its own number of this kind for each edge: "s_0".
bool hasForEachEdge(const TracedScene &traced, const char *id)
{
    return hasNumber(traced.trace->numbers().setUp, QString::fromLatin1(id) + u"_0"_s);
}

/// On which sides of an edge the off-screen point and the triangle lie, in the method's numbers:
/// whether f_bc(a)·f_bc(r) > 0.
QString sidesText(const TracedScene &traced, std::size_t index, const oracle::EdgeVerdict &edge)
{
    const Triangle &triangle = traced.primitives.triangles[index];
    const LatticePoint offScreenPoint = boundaryRuleOf(traced.scene).offScreenPoint;
    const auto position
        = [&](int vertex) { return triangle.vertices[std::size_t(vertex)].position; };
    const LatticePoint facing = position(3 - edge.from - edge.to);
    const auto functionAt = [&](const LatticePoint &point) {
        return edgeFunctionAt(position(edge.from), position(edge.to), point);
    };
    const Quantity product = productOf(functionAt(facing), functionAt(offScreenPoint));
    const bool isOnSameSide = product.numerator() > 0;
    const auto text = [&](const Quantity &there, const Quantity &here, const Quantity &both) {
        return u"the edge's function is %1 at the off-screen point %2 and %3 at the "
               "vertex that faces it; their product, %4, is %5 0"_s.arg(
                   term(there), pointText(offScreenPoint), term(here), term(both),
                   isOnSameSide ? u"above"_s : u"not above"_s);
    };
    // A solved system's equations are scaled differently, each edge on its own.
    if (hasForEachEdge(traced, "q")) {
        const int line = (edge.from + 1) % 3 == edge.to ? edge.from : edge.to;
        const ScanTrace &exact = traced.exactTrace ? *traced.exactTrace : *traced.trace;
        const SetUpRecord setUp = exact.setUp(index);
        const NamedNumbers numbers(exact.numbers().setUp, setUp.cells);
        return text(numbers[u"E_%1_r"_s.arg(line)], numbers[u"F_%1"_s.arg(line)],
                    numbers[u"tie_product_%1"_s.arg(line)]);
    }
    // Swapped sides make a function positive inside.
    const bool isExchanged = hasForEachEdge(traced, "s") && functionAt(facing).numerator() < 0;
    const Quantity sign = Quantity::integer(isExchanged ? -1 : 1);
    return text(productOf(sign, functionAt(offScreenPoint)), productOf(sign, functionAt(facing)),
                product);
}

/// On which side of an edge its triangle lies, as top-left and half-open-column need it.
QString placeText(const TracedScene &traced, const Triangle &triangle,
                  const oracle::EdgeVerdict &edge)
{
    const auto position
        = [&](int vertex) { return triangle.vertices[std::size_t(vertex)].position; };
    const LatticePoint from = position(edge.from);
    const LatticePoint to = position(edge.to);
    const bool isCounterClockwise = doubledArea(from, to, position(3 - edge.from - edge.to)) > 0;
    const bool isAtLargerX = isCounterClockwise == (to.y < from.y);
    const bool isAtLargerY = isCounterClockwise == (to.x > from.x);
    if (traced.scene.settings.fillRule == FillRule::TopLeft && from.y != to.y)
        return isAtLargerX ? u"the triangle lies at larger x, so the edge is a left one"_s
                           : u"the triangle lies at smaller x, so the edge is a right one"_s;
    if (traced.scene.settings.fillRule == FillRule::TopLeft) {
        const bool isBelow = isAtLargerY == (traced.scene.frame.origin == FrameOrigin::TopLeft);
        return isBelow ? u"the edge is level, and the triangle lies below it"_s
                       : u"the edge is level, and the triangle lies above it"_s;
    }
    if (from.x != to.x)
        return isAtLargerY ? u"the triangle lies at larger y of the edge"_s
                           : u"the triangle lies at smaller y of the edge"_s;
    return isAtLargerX ? u"the edge is upright, and the triangle lies at larger x"_s
                       : u"the edge is upright, and the triangle lies at smaller x"_s;
}

} // namespace

QString tieText(const TracedScene &traced, std::size_t triangle, const oracle::EdgeVerdict &edge,
                std::int64_t x, std::int64_t y)
{
    const FillRule rule = traced.scene.settings.fillRule;
    const auto givenTo = [&](const QString &side) {
        const QString given = u"the rule %1 gives it to %2"_s.arg(nameText(nameOf(rule)), side);
        return given + u": "_s
            + (rule == FillRule::OffScreenPoint
                   ? sidesText(traced, triangle, edge)
                   : placeText(traced, traced.primitives.triangles[triangle], edge));
    };
    if (edge.accepts)
        return givenTo("this side");
    const Triangle neighbour = acrossEdge(traced.primitives.triangles[triangle], edge);
    const auto isSame = [&](const oracle::EdgeVerdict &other) {
        return other.from == edge.from && other.to == edge.to;
    };
    const oracle::SampleVerdict there = verdictOn(neighbour, traced, x, y);
    if (std::ranges::find_if(there.edges, isSame)->accepts)
        return givenTo("the other side");
    if (rule == FillRule::OffScreenPoint)
        return u"the off-screen point lies on this edge's line too: neither side owns it"_s;
    return u"the rule %1 gives it to neither side"_s.arg(nameText(nameOf(rule)));
}

namespace {

/// Whether it is u + v of Cramer's rule, which decides by 1 in place of 0.
bool isSum(const SampleDecision &decision) { return decision.title == u"s"_s; }

QString nameOf(const SampleDecision &decision)
{
    return isSum(decision) ? u"s = u + v"_s : decision.title;
}

/// "γ = 0": the numbers by which the run has the sample on an edge.
QStringList tiesOf(std::span<const SampleDecision> decisions)
{
    QStringList ties;
    for (const SampleDecision &decision : decisions) {
        const double onEdge = isSum(decision) ? 1 : 0;
        if (!decision.value.isNone() && decision.value.toDouble() == onEdge)
            ties.append(u"%1 = %2"_s.arg(nameOf(decision), term(decision.value)));
    }
    return ties;
}

/// Which weight is too large for a listing that requires weights of at most 1: "0 ≤ α ≤ 1".
QString aboveOneText(const TracedScene &traced, std::span<const SampleDecision> decisions)
{
    const bool isBounded
        = std::ranges::any_of(traced.method->pseudocode, [](const PseudocodeLine &line) {
              return line.text.contains(u"α ≤ 1"_s);
          });
    for (const SampleDecision &decision : decisions) {
        const bool isAbove = !decision.value.isNone() && decision.value.toDouble() > 1;
        if (isAbove && (isBounded || isSum(decision)))
            return u"Refused: %1 = %2 is above 1."_s.arg(nameOf(decision), term(decision.value));
    }
    return {};
}

} // namespace

std::vector<SampleDecision> decisionsOf(const std::vector<NumberDescription> &columns,
                                        const SampleRecord &sample)
{
    std::vector<SampleDecision> decisions;
    for (std::size_t i = 0; i < columns.size() && i < sample.cells.size(); ++i) {
        if (columns[i].group == NumberGroup::Decision)
            decisions.push_back({columns[i].title, sample.cells[i]});
    }
    return decisions;
}

QString refusalSentence(const TracedScene &traced, std::size_t triangle, const SampleRecord &sample,
                        std::span<const SampleDecision> decisions)
{
    QStringList failed;
    for (const SampleDecision &decision : decisions) {
        if (!decision.value.isNone() && decision.value.toDouble() < 0)
            failed.append(u"%1 = %2"_s.arg(decision.title, term(decision.value)));
    }
    if (!failed.isEmpty())
        return u"Refused: %1 %2 negative."_s.arg(failed.join(u", "_s),
                                                 failed.size() == 1 ? u"is"_s : u"are"_s);

    QStringList unordered;
    for (const SampleDecision &decision : decisions) {
        if (!decision.value.isNone() && std::isnan(decision.value.toDouble()))
            unordered.append(decision.title);
    }
    if (!unordered.isEmpty())
        return u"Refused: %1 not a number in the run's arithmetic, so every "
               "comparison with %2 fails."_s.arg(
                   unordered.join(u", "_s) + (unordered.size() == 1 ? u" is"_s : u" are"_s),
                   unordered.size() == 1 ? u"it"_s : u"them"_s);

    const QString above = aboveOneText(traced, decisions);
    if (!above.isEmpty())
        return above;
    const oracle::SampleVerdict verdict
        = verdictOn(traced.primitives.triangles[triangle], traced, sample.x, sample.y);
    if (verdict.zeroArea)
        return u"Refused: the triangle has no area, and %1."_s.arg(
            segmentText(traced.primitives.triangles[triangle], sample.x, sample.y));
    const SetUpRecord setUp = traced.trace->setUp(triangle);
    QStringList ties;
    for (const oracle::EdgeVerdict &edge : verdict.edges) {
        if (edge.edgeFunction == 0 && !edge.accepts)
            ties.append(u"exactly on %1, and %2"_s.arg(
                edgeName(setUp, edge.from, edge.to),
                tieText(traced, triangle, edge, sample.x, sample.y)));
    }
    if (!ties.isEmpty())
        return u"Refused: the sample lies %1."_s.arg(ties.join(u"; it lies "_s));
    if (const QStringList met = tiesOf(decisions); !met.isEmpty())
        return u"Refused: by the run's numbers the sample lies on an edge, %1, and "
               "the rule %2 leaves it out."_s.arg(met.join(u", "_s),
                                                  nameText(nameOf(traced.scene.settings.fillRule)));
    return u"Refused by rounding: no test of the run says why."_s;
}

QString noPartText(const TracedScene &traced)
{
    switch (traced.antialiasing()) {
    case Antialiasing::None:
        break;
    case Antialiasing::Samples4:
    case Antialiasing::Samples16:
        return u"No sample of the pixel lies in the triangle."_s;
    case Antialiasing::Area:
        return u"The triangle covers no part of the pixel's square."_s;
    }
    return {};
}

} // namespace pixelplumb
