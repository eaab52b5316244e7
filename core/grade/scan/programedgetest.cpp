// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/programedgetest.h"

#include "core/grade/scan/planelevels.h"
#include "core/scan/tests/edgetestsetup.h"
#include "core/scan/tests/planearithmetic.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// Whether the samples on each edge are inside.
std::array<bool, 3> ownersByRule(const Triangle &triangle, const BoundaryRule &rule)
{
    EdgeTestSetUp<ExactPlane<Int128>> setUp;
    setUp.vertices = triangle.vertices;
    for (std::size_t edge = 0; edge < 3; ++edge)
        setLine<ExactPlane<Int128>, edgeEquationsForm>(setUp, edge, rule);
    return setUp.ownsTie;
}

/// One triangle as this program draws it.
class TestedTriangle {
public:
    TestedTriangle(const ProgramEdgeTest &program, const TriangleRuns &runs)
        : m_program(program)
        , m_runs(runs)
        , m_triangle(exchanged(runs.triangle))
        , m_area(functionOf(0, m_triangle.vertices[2].position))
        , m_ownsByRule(ownersByRule(m_triangle, runs.rule))
    {
        if (!runs.side || runs.side->arithmetic == Arithmetic::Exact)
            return;
        const ArithmeticBound bound = boundOn(*runs.side, m_triangle);
        m_functionError = bound.functionError() * double(squarePixel);
        m_weightError = 16 * bound.unit();
    }

    std::vector<SampleRun> runs() const
    {
        std::vector<SampleRun> result;
        if (m_area == 0)
            return result;
        const SampleBox &box = m_runs.visited;
        for (std::int64_t y = std::max(box.firstY, m_runs.firstSpan);
             y < std::min(box.endY, m_runs.endSpan); ++y)
            appendRow(y, result);
        return result;
    }

private:
    void appendRow(std::int64_t y, std::vector<SampleRun> &result) const
    {
        std::optional<SampleRun> run;
        const auto finish = [&] {
            if (run)
                result.push_back(*std::move(run));
            run.reset();
        };
        for (std::int64_t x = m_runs.visited.firstX; x < m_runs.visited.endX; ++x) {
            const EdgeFunctions functions = functionsAt(x, y);
            if (!isInside(functions)) {
                if (m_program.outside == OutsideSample::EndsRow)
                    break;
                finish();
                continue;
            }
            if (x < m_runs.firstSample || x >= m_runs.endSample)
                continue;
            if (!run)
                run = SampleRun{y, x, x, {}, x};
            run->end = x + 1;
            if (m_program.changesColours())
                run->levels.push_back(levelsOf(functions));
        }
        finish();
    }
    /// The edge's start and end.
    std::pair<LatticePoint, LatticePoint> edgeOf(std::size_t edge) const
    {
        return {m_triangle.vertices[edge].position, m_triangle.vertices[(edge + 1) % 3].position};
    }
    Int128 functionOf(std::size_t edge, const LatticePoint &at) const
    {
        const auto [from, to] = edgeOf(edge);
        return m_program.function ? m_program.function(from, to, at) : doubledArea(from, to, at);
    }
    EdgeFunctions functionsAt(std::int64_t x, std::int64_t y) const
    {
        LatticePoint at = latticePixel(x, y);
        if (m_program.place)
            at = m_program.place(m_triangle, m_runs.visited, at);
        const int sign = m_area < 0 ? -1 : 1;
        EdgeFunctions functions;
        functions.area = m_area * sign;
        for (std::size_t edge = 0; edge < 3; ++edge)
            functions.values[edge] = functionOf(edge, at) * sign;
        if (m_program.change)
            m_program.change(functions);
        return functions;
    }
    bool isInside(const EdgeFunctions &functions) const
    {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (!isInside(functions, edge))
                return false;
        }
        return true;
    }
    bool isInside(const EdgeFunctions &functions, std::size_t edge) const
    {
        const EdgeQuestion question = m_program.questions[edge];
        if (question == EdgeQuestion::Nothing)
            return true;
        const Int128 value = functions.values[edge];
        const Int128 inward = (question == EdgeQuestion::IsOutside ? -value : value)
            + slackOf(edge, functions.area);
        const bool isOpen = m_runs.side && std::abs(double(inward)) <= m_functionError;
        if (isOpen)
            return m_runs.side->isOutward;
        if (inward != 0)
            return inward > 0;
        if (m_program.slack != EdgeSlack::None)
            return m_program.slack != EdgeSlack::OfHalf;
        return ownsTie(edge);
    }
    Int128 slackOf(std::size_t edge, Int128 area) const
    {
        switch (m_program.slack) {
        case EdgeSlack::None:
            return 0;
        case EdgeSlack::OfFunction:
            return squarePixel;
        case EdgeSlack::OfHalf:
            return squarePixel / 2;
        case EdgeSlack::OfTenth: // not an integer in its units
            return squarePixel / 10;
        case EdgeSlack::OfDistance:
            break;
        case EdgeSlack::OfWeight:
            return area / 100;
        }
        const auto [from, to] = edgeOf(edge);
        return Int128(std::hypot(double(to.x - from.x), double(to.y - from.y)) * halfPixel);
    }
    bool ownsTie(std::size_t edge) const
    {
        const auto [from, to] = edgeOf(edge);
        const int sign = m_area < 0 ? -1 : 1;
        const Lattice perX = (from.y - to.y) * sign; // of the function, which increases inward
        const Lattice perY = (to.x - from.x) * sign;
        switch (m_program.owner) {
        case EdgeOwner::OfRule:
            return m_ownsByRule[edge];
        case EdgeOwner::BottomRight:
            return perX != 0 ? perX < 0 : perY > 0;
        case EdgeOwner::BottomLeft:
            return perX != 0 ? perX > 0 : perY > 0;
        case EdgeOwner::TopRight:
            return perX != 0 ? perX < 0 : perY < 0;
        }
        return true;
    }
    WholeLevels levelsOf(const EdgeFunctions &functions) const
    {
        const auto &e = functions.values;
        VertexWeights weights{{e[1], e[2], e[0]}, functions.area};
        if (m_program.weigh)
            m_program.weigh(weights);
        WholeLevels levels;
        for (std::size_t channel = 0; channel < 3; ++channel)
            levels[channel]
                = m_runs.side ? levelOnSide(weights, channel) : levelOf(weights, channel);
        return levels;
    }
    int levelAt(std::size_t vertex, std::size_t channel) const
    {
        return m_triangle.vertices[vertex].colour.channels[channel];
    }
    std::int64_t levelOf(const VertexWeights &weights, std::size_t channel) const
    {
        CommonFraction sum{0, weights.denominator};
        for (std::size_t i = 0; i < 3; ++i) {
            CommonFraction product
                = CommonFraction{weights.numerators[i], weights.denominator} * levelAt(i, channel);
            const bool isCut = m_program.product == WeightedProduct::Cut;
            if (m_program.product != WeightedProduct::AsItIs)
                product.numerator = product.denominator
                    * (isCut ? product.numerator / product.denominator : product.nearest());
            sum = sum + product;
        }
        const bool isNearest = m_runs.settings.rounding == ByteRounding::Nearest;
        return std::int64_t(isNearest ? sum.nearest() : sum.floor());
    }
    /// The level with the error of a program that computes weights in the side's arithmetic.
    std::int64_t levelOnSide(const VertexWeights &weights, std::size_t channel) const
    {
        const auto denominator = double(weights.denominator);
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = double(weights.numerators[i]) / denominator;
            const double error = 16 * m_functionError / denominator
                + m_weightError * std::max(1.0, std::abs(weight));
            const double product
                = (weight + (m_runs.side->isUpward ? error : -error)) * levelAt(i, channel);
            sum += m_program.product == WeightedProduct::Cut    ? std::trunc(product)
                : m_program.product == WeightedProduct::Rounded ? std::floor(product + 0.5)
                                                                : product;
        }
        const bool isNearest = m_runs.settings.rounding == ByteRounding::Nearest;
        return std::int64_t(std::floor(sum + (isNearest ? 0.5 : 0)));
    }

    const ProgramEdgeTest &m_program;
    const TriangleRuns &m_runs;
    const Triangle m_triangle; ///< as given: x is a column
    const Int128 m_area;
    const std::array<bool, 3> m_ownsByRule;
    double m_functionError = 0; ///< of an edge function, square lattice units
    double m_weightError = 0; ///< of a weight, besides the functions' errors
};

} // namespace

Redrawing redrawingByTests(const ProgramEdgeTest &program, LevelOverflow overflow)
{
    const auto shared = std::make_shared<const ProgramEdgeTest>(program);
    const auto change = [shared](TriangleRuns &triangle) {
        if (doubledArea(triangle.triangle) != 0) // without area there are no weights
            triangle.runs = TestedTriangle(*shared, triangle).runs();
    };
    Redrawing redrawing{change, overflow};
    redrawing.edgeTest = shared;
    return redrawing;
}

} // namespace pixelplumb
