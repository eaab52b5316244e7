// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/commonfraction.h"
#include "core/scan/edgetestbugs.h"
#include "core/scan/tests/edgetestsetup.h"

#include <cmath>
#include <optional>

/// The edge test of a program with bugs (edgetestbugs.h), in exact numbers. Without bugs it draws
/// what the edge tests draw.
namespace pixelplumb {

/// Three edge functions at a sample, square lattice units, positive inside.
struct EdgeFunctions {
    std::array<Int128, 3> values = {}; ///< for the edges from vertex 0 to 1, 1 to 2, 2 to 0
    Int128 area = 0; ///< doubled, positive; the divisor of the weights
};

/// The weight of each vertex's colour, over one denominator.
struct VertexWeights {
    std::array<Int128, 3> numerators = {};
    Int128 denominator = 1; ///< > 0
};

/// A side of what rounding may do to the program's numbers.
struct EdgeTestSide {
    double functionError = 0; ///< of an edge function, square lattice units
    double weightError = 0; ///< of a weight, besides the functions' errors
    bool isOutward = false;
    bool isUpward = false;
};

/// One triangle as the program draws it.
class MistakenEdgeTest {
public:
    MistakenEdgeTest(const EdgeTestBugs &bugs, const Triangle &triangle, const BoundaryRule &rule,
                     const SampleBox &visited, std::optional<EdgeTestSide> side = {})
        : m_bugs(bugs)
        , m_triangle(triangle)
        , m_visited(visited)
        , m_side(side)
        , m_area(functionOf(0, m_triangle.vertices[2].position))
    {
        EdgeTestSetUp<ExactPlane<Int128>> setUp;
        setUp.vertices = triangle.vertices;
        for (std::size_t edge = 0; edge < 3; ++edge)
            setLine<ExactPlane<Int128>, edgeEquationsForm>(setUp, edge, rule);
        m_ownsByRule = setUp.ownsTie;
    }

    /// Where the area comes out as 0, nothing is drawn.
    bool hasArea() const { return m_area != 0; }
    int turn() const { return m_area < 0 ? -1 : 1; }

    EdgeFunctions functionsAt(std::int64_t x, std::int64_t y) const
    {
        const LatticePoint at = placeOf(latticePixel(x, y));
        EdgeFunctions own;
        own.area = m_area * turn();
        for (std::size_t edge = 0; edge < 3; ++edge)
            own.values[edge] = functionOf(edge, at) * turn();
        EdgeFunctions functions = own;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            switch (m_bugs.values[edge]) {
            case EdgeValue::Own:
                break;
            case EdgeValue::Negated:
                functions.values[edge] = -own.values[edge];
                break;
            case EdgeValue::OfNext:
                functions.values[edge] = own.values[(edge + 1) % 3];
                break;
            case EdgeValue::OfPrevious:
                functions.values[edge] = own.values[(edge + 2) % 3];
                break;
            }
        }
        return functions;
    }
    bool isInside(const EdgeFunctions &functions) const
    {
        return isInside(functions, 0) && isInside(functions, 1) && isInside(functions, 2);
    }
    /// Where the row's loop ends, from the box' first sample on.
    std::int64_t endOfRow(std::int64_t y) const
    {
        std::int64_t x = m_visited.firstX;
        if (m_bugs.outside == OutsideSample::GoesOn)
            return m_visited.endX;
        while (x < m_visited.endX && isInside(functionsAt(x, y)))
            ++x;
        return x;
    }

    VertexWeights weightsOf(const EdgeFunctions &functions) const
    {
        const auto &e = functions.values;
        const std::array<Int128, 3> own = {e[1], e[2], e[0]};
        VertexWeights weights{own, functions.area};
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            const Int128 next = own[(vertex + 1) % 3];
            const Int128 previous = own[(vertex + 2) % 3];
            Int128 &weight = weights.numerators[vertex];
            switch (m_bugs.weights[vertex]) {
            case WeightForm::Own:
                break;
            case WeightForm::Missing:
                weight = 0;
                break;
            case WeightForm::OfNext:
                weight = next;
                break;
            case WeightForm::OfPrevious:
                weight = previous;
                break;
            case WeightForm::AddsNext:
                weight += 2 * next;
                break;
            case WeightForm::AddsPrevious:
                weight += 2 * previous;
                break;
            case WeightForm::LeavesNext:
                weight += next;
                break;
            case WeightForm::LeavesPrevious:
                weight += previous;
                break;
            }
            if (m_bugs.divisor == WeightDivisor::Area)
                weight *= 2;
        }
        if (m_bugs.divisor == WeightDivisor::Nothing)
            weights.denominator = squareUnitsPerPixel;
        if (m_bugs.keptWeight == KeptWeight::Whole) {
            for (Int128 &weight : weights.numerators)
                weight = weight / weights.denominator * weights.denominator;
        }
        return weights;
    }
    /// A channel before it is rounded to a byte.
    CommonFraction levelOf(const VertexWeights &weights, std::size_t channel) const
    {
        CommonFraction sum{0, weights.denominator};
        for (std::size_t i = 0; i < 3; ++i) {
            CommonFraction product
                = CommonFraction{weights.numerators[i], weights.denominator} * levelAt(i, channel);
            const bool isCut = m_bugs.product == WeightedProduct::Cut;
            if (m_bugs.product != WeightedProduct::AsItIs)
                product.numerator = product.denominator
                    * (isCut ? product.numerator / product.denominator : product.nearest());
            sum = sum + product;
        }
        return sum;
    }
    /// On the side, whose errors it has.
    double levelOnSide(const VertexWeights &weights, std::size_t channel) const
    {
        const auto denominator = double(weights.denominator);
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = double(weights.numerators[i]) / denominator;
            const double error = 16 * m_side->functionError / denominator
                + m_side->weightError * std::max(1.0, std::abs(weight));
            const double product
                = (weight + (m_side->isUpward ? error : -error)) * levelAt(i, channel);
            sum += m_bugs.product == WeightedProduct::Cut    ? std::trunc(product)
                : m_bugs.product == WeightedProduct::Rounded ? std::floor(product + 0.5)
                                                             : product;
        }
        return sum;
    }

private:
    LatticePoint positionOf(std::size_t vertex) const
    {
        return m_triangle.vertices[vertex % 3].position;
    }
    int levelAt(std::size_t vertex, std::size_t channel) const
    {
        return m_triangle.vertices[vertex].colour.channels[channel];
    }

    LatticePoint placeOf(const LatticePoint &sample) const
    {
        const LatticePoint corner = latticePixel(m_visited.firstX, m_visited.firstY);
        switch (m_bugs.place) {
        case TestedPlace::OfSample:
            break;
        case TestedPlace::NotSetBack:
            return {sample.x + (m_visited.endX - m_visited.firstX) * (sample.y - corner.y),
                    sample.y};
        case TestedPlace::StepsExchanged:
            return {corner.x + (sample.y - corner.y), corner.y + (sample.x - corner.x)};
        case TestedPlace::FromBoxCorner: {
            const LatticePoint least = boundingCornersOf(m_triangle).first;
            return {sample.x - corner.x + least.x, sample.y - corner.y + least.y};
        }
        }
        return sample;
    }
    Int128 functionOf(std::size_t edge, const LatticePoint &at) const
    {
        const LatticePoint from = positionOf(edge);
        const LatticePoint to = positionOf(edge + 1);
        const auto whole = [](Int128 f) { return f / squareUnitsPerPixel * squareUnitsPerPixel; };
        const auto inShort = [](Int128 square) {
            return std::int16_t(square / squareUnitsPerPixel) * squareUnitsPerPixel;
        };
        const Int128 one = Int128(to.x - from.x) * (at.y - from.y);
        const Int128 other = Int128(to.y - from.y) * (at.x - from.x);
        switch (m_bugs.function) {
        case EdgeFunctionForm::Right:
            break;
        case EdgeFunctionForm::Cut:
            return whole(one - other);
        case EdgeFunctionForm::Floored:
            return floorDivide<Int128>(one - other, squareUnitsPerPixel) * squareUnitsPerPixel;
        case EdgeFunctionForm::ProductsCut:
            return whole(one) - whole(other);
        case EdgeFunctionForm::CoefficientsCut: {
            const auto cut = [](Int128 length) { return length / unitsPerPixel * unitsPerPixel; };
            const Int128 c = Int128(to.y - from.y) * from.x - Int128(to.x - from.x) * from.y;
            return cut(from.y - to.y) * at.x + cut(to.x - from.x) * at.y + whole(c);
        }
        case EdgeFunctionForm::ProductsAdded:
            return one + other;
        case EdgeFunctionForm::InShort:
            return inShort(one - other);
        case EdgeFunctionForm::ProductsInShort:
            return inShort(one) - inShort(other);
        }
        return one - other;
    }

    bool isInside(const EdgeFunctions &functions, std::size_t edge) const
    {
        const EdgeQuestion question = m_bugs.questions[edge];
        if (question == EdgeQuestion::Nothing)
            return true;
        const Int128 value = functions.values[edge];
        const Int128 inward = (question == EdgeQuestion::IsOutside ? -value : value)
            + slackOf(edge, functions.area);
        if (m_side && std::abs(double(inward)) <= m_side->functionError)
            return m_side->isOutward;
        if (inward != 0)
            return inward > 0;
        if (m_bugs.slack != EdgeSlack::None)
            return m_bugs.slack != EdgeSlack::OfHalf;
        return ownsTieOf(edge);
    }
    Int128 slackOf(std::size_t edge, Int128 area) const
    {
        switch (m_bugs.slack) {
        case EdgeSlack::None:
            return 0;
        case EdgeSlack::OfFunction:
            return squareUnitsPerPixel;
        case EdgeSlack::OfHalf:
            return squareUnitsPerPixel / 2;
        case EdgeSlack::OfTenth: // not an integer in its units
            return squareUnitsPerPixel / 10;
        case EdgeSlack::OfDistance:
            break;
        case EdgeSlack::OfWeight:
            return area / 100;
        }
        const LatticePoint from = positionOf(edge);
        const LatticePoint to = positionOf(edge + 1);
        return Int128(std::hypot(double(to.x - from.x), double(to.y - from.y)) * halfPixel);
    }
    bool ownsTieOf(std::size_t edge) const
    {
        const Lattice perX = (positionOf(edge).y - positionOf(edge + 1).y) * turn(); // inward
        const Lattice perY = (positionOf(edge + 1).x - positionOf(edge).x) * turn();
        switch (m_bugs.owner) {
        case EdgeOwner::OfRule:
            return m_ownsByRule[edge];
        case EdgeOwner::BottomRight:
            return perX != 0 ? perX < 0 : perY > 0;
        case EdgeOwner::BottomLeft:
            return perX != 0 ? perX > 0 : perY > 0;
        case EdgeOwner::TopRight:
            return perX != 0 ? perX < 0 : perY < 0;
        case EdgeOwner::AsGiven:
            return perX != 0 ? perX * turn() > 0 : perY * turn() < 0;
        }
        return true;
    }

    const EdgeTestBugs m_bugs;
    const Triangle m_triangle; ///< x is a column
    const SampleBox m_visited;
    const std::optional<EdgeTestSide> m_side;
    const Int128 m_area;
    std::array<bool, 3> m_ownsByRule = {};
};

} // namespace pixelplumb
