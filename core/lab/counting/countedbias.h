// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationtally.h"
#include "core/scan/biasarithmetic.h"

namespace pixelplumb {

/// The half-quantum arithmetic with its operations counted at each step: y = y₀ + run·m, rounded
/// with the bias. What it computes in integers outside its proved domain, and the test of that
/// domain, are not counted.
struct CountedBias : BiasArithmetic<BiasOrExactNumber> {
    using Base = BiasArithmetic<BiasOrExactNumber>;

    /// Two differences, each converted to double; one quotient.
    static Number edgeSlope(const Vertex &a, const Vertex &b)
    {
        const Number slope = Base::edgeSlope(a, b);
        if (!slope.isExact && a.position.x != b.position.x)
            countQuotient();
        return slope;
    }
    static Lattice runTo(std::int64_t column, const Vertex &a)
    {
        OperationTally::count(Operation::IntegerAddition);
        return Base::runTo(column, a);
    }
    static Number edgeOrdinate(const Vertex &a, const Vertex &b, Lattice run, const Number &slope)
    {
        const Number ordinate = Base::edgeOrdinate(a, b, run, slope);
        countStart(ordinate);
        return ordinate;
    }
    static Number edgeColourRate(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        const Number rate = Base::edgeColourRate(a, b, channel);
        if (!rate.isExact && a.position.x != b.position.x)
            countQuotient();
        return rate;
    }
    static Number edgeColour(const Vertex &a, const Vertex &b, std::size_t channel, Lattice run,
                             const Number &rate)
    {
        const Number colour = Base::edgeColour(a, b, channel, run, rate);
        countStart(colour);
        return colour;
    }

    static std::int64_t floor(const Number &number)
    {
        countRounded(number);
        return Base::floor(number);
    }
    static std::int64_t ceil(const Number &number)
    {
        countRounded(number);
        return Base::ceil(number);
    }
    /// One step farther: run + 1.
    static void advance(Number &number, const Number &rate)
    {
        if (!number.isExact)
            OperationTally::count(Operation::FloatAddition);
        Base::advance(number, rate);
    }
    /// The half belongs to the rounding, as in every arithmetic.
    static std::int64_t level(const Number &number, ByteRounding rounding)
    {
        countRounded(number);
        return Base::level(number, rounding);
    }

    class ColourRamp : public Base::ColourRamp {
    public:
        /// The plane: four differences of coordinates and two products make its area, which the
        /// bias divides; three levels of P0 become doubles; two differences of levels, four
        /// products and two additions make a channel's two numerators, each scaled, converted to
        /// double and divided.
        ColourRamp(const Vertex &p0, const Vertex &p1, const Vertex &p2)
            : Base::ColourRamp(p0, p1, p2)
            , m_hasPlane(doubledArea(p0.position, p1.position, p2.position) != 0)
        {
            if (!biasdomain::containsPlane({{p0, p1, p2}}))
                return;
            OperationTally::count(Operation::IntegerAddition, 5);
            OperationTally::count(Operation::Multiplication, 2);
            OperationTally::count(Operation::Conversion, 1 + 3);
            if (!m_hasPlane)
                return;
            OperationTally::count(Operation::Division);
            OperationTally::count(Operation::IntegerAddition, 3 * 4);
            OperationTally::count(Operation::Multiplication, 3 * 6);
            OperationTally::count(Operation::Conversion, 3 * 2);
            OperationTally::count(Operation::Division, 3 * 2);
        }
        /// The distances to the row and to the column become doubles; each channel computes c₀ +
        /// g_x·Δx.
        template <class ColumnState>
        std::array<Number, 3> starts(const ColumnState &column, std::int64_t row) const
        {
            const std::array<Number, 3> numbers = Base::ColourRamp::starts(column, row);
            if (!numbers[0].isExact && m_hasPlane) {
                OperationTally::count(Operation::IntegerAddition, 2);
                OperationTally::count(Operation::Conversion, 2);
                OperationTally::count(Operation::Multiplication, 3);
                OperationTally::count(Operation::FloatAddition, 3);
            }
            return numbers;
        }

    private:
        bool m_hasPlane = false;
    };

private:
    static void countQuotient()
    {
        OperationTally::count(Operation::IntegerAddition, 2);
        OperationTally::count(Operation::Conversion, 2);
        OperationTally::count(Operation::Division);
    }
    /// The value at the first vertex, the distance from there, and the divisor of β.
    static void countStart(const Number &number)
    {
        if (number.isExact)
            return;
        OperationTally::count(Operation::Conversion, 3);
        OperationTally::count(Operation::Division);
    }
    /// origin + run·rate ± bias, to an integer.
    static void countRounded(const Number &number)
    {
        if (number.isExact)
            return;
        OperationTally::count(Operation::Multiplication);
        OperationTally::count(Operation::FloatAddition, 2);
        OperationTally::count(Operation::Rounding);
    }
};

} // namespace pixelplumb
