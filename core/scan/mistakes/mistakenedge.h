// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/fractionwalk.h"
#include "core/scan/mistakes/walkedprogram.h"

#include <type_traits>

namespace pixelplumb {

/// Where an edge meets the current span, in the numbers of the program: the scan's own steps, in
/// numbers that round or in fractions.
template <class Value>
class MistakenEdge {
    using A = RoundedArithmetic<Value>;
    using Traits = NumberTraits<Value>;

public:
    MistakenEdge(const WalkedEdge &edge, const ScanBugs &bugs, std::int64_t span)
        : m_bugs(bugs)
        , m_slope(leftOf(A::edgeSlope(edge.places.a, edge.places.b), bugs.slopes))
        , m_along(A::edgeOrdinate(edge.firstPlace, edge.places.b, A::runTo(span, edge.firstPlace),
                                  m_slope))
        , m_vertex(edge.firstPlace.position.y)
        , m_vertexColour(edge.firstColour.colour)
        , m_run(edge.places.b.position.x - edge.places.a.position.x)
    {
        const auto &[a, b] = edge.colours;
        std::array<Value, 3> rates;
        for (std::size_t i = 0; i < 3; ++i) {
            rates[i] = leftOf(A::edgeColourRate(a, b, sourceOf(i, bugs.ratesAlongEdgesOf)),
                              bugs.edgeColours);
            const Value run = bugs.withoutEdgePreStep.isEmpty()
                ? A::runTo(span, edge.firstColour)
                : Traits::fromLattice(wayToSpan(edge.firstColour.position.x, span, bugs, i));
            m_levels[i] = A::edgeColour(edge.firstColour, b, i, run, rates[i]);
        }
        m_isLevel = m_slope == Traits::fromInteger(0);
        if (bugs.edgeStoring == Storing::FromFirst) {
            m_along = leftOf(m_along, bugs.edgePlaces);
            for (Value &level : m_levels)
                level = leftOf(level, bugs.edgeLevels);
        }
        for (std::size_t i = 0; i < 3; ++i)
            m_rates[i] = bugs.unsteppedAlongEdges.contains(i)
                ? Traits::fromInteger(0)
                : rates[sourceOf(i, bugs.stepsAlongEdgesOf)];
        if constexpr (std::is_same_v<Value, Fraction>) { // steps are then added at once
            putOverOneDenominator(m_along, m_slope);
            for (std::size_t i = 0; i < 3; ++i)
                putOverOneDenominator(m_levels[i], m_rates[i]);
        }
    }

    void stepPlace()
    {
        stepBy(m_along, m_slope);
        if (m_bugs.edgePlaces != Truncation::All && !isOfAdded(m_bugs.edgeStoring))
            m_along = leftOf(m_along, m_bugs.edgePlaces);
    }
    void stepColour()
    {
        for (std::size_t i = 0; i < 3; ++i) {
            stepBy(m_levels[i], m_rates[i]);
            if (m_bugs.edgeLevels != Truncation::All && !isOfAdded(m_bugs.edgeStoring))
                m_levels[i] = leftOf(m_levels[i], m_bugs.edgeLevels);
        }
    }

    void carryPlaceOf(const MistakenEdge &other)
    {
        m_along = other.m_along;
        m_isLevel = m_isLevel && other.m_isLevel;
    }
    void carryColourOf(const MistakenEdge &other) { m_levels = other.m_levels; }
    void goOnWithPlacesOf(const MistakenEdge &other)
    {
        m_along = other.m_along;
        m_slope = other.m_slope;
        m_isLevel = other.m_isLevel;
        m_vertex = other.m_vertex;
        m_run = other.m_run;
    }
    void goOnWithColoursOf(const MistakenEdge &other)
    {
        m_levels = other.m_levels;
        m_rates = other.m_rates;
        m_vertexColour = other.m_vertexColour;
    }
    void stepAsPlacesOf(const MistakenEdge &other)
    {
        m_slope = other.m_slope;
        m_isLevel = m_isLevel && other.m_isLevel;
    }
    void stepAsColoursOf(const MistakenEdge &other) { m_rates = other.m_rates; }
    void holdPlace() { m_slope = Traits::fromInteger(0); }
    void holdColour() { m_rates.fill(Traits::fromInteger(0)); }

    /// Nothing rounds along a level edge, so that it stays.
    void moveBy(double along) requires std::is_same_v<Value, double>
    {
        if (!m_isLevel)
            m_along += along;
    }
    bool isBelow(const MistakenEdge &other) const { return place() < other.place(); }
    std::int64_t floor() const { return A::floor(place()); }
    std::int64_t ceil() const { return A::ceil(place()); }
    std::int64_t nearest() const { return wholeLevel(place(), ByteRounding::Nearest); }

    Value place() const ///< px
    {
        if (m_bugs.edgePlaces == Truncation::All || !isOfAdded(m_bugs.edgeStoring))
            return m_along;
        const Value from = Traits::fromLattice(m_vertex);
        return from + wholeAdded(m_along - from, m_bugs.edgePlaces);
    }
    const Value &slope() const { return m_slope; } ///< px per span
    Value level(std::size_t channel) const
    {
        if (m_bugs.edgeLevels == Truncation::All || !isOfAdded(m_bugs.edgeStoring))
            return m_levels[channel];
        const Value from = Traits::fromInteger(m_vertexColour.channels[channel]);
        return from + wholeAdded(m_levels[channel] - from, m_bugs.edgeLevels);
    }
    std::array<Value, 3> colour() const { return {level(0), level(1), level(2)}; }
    const std::array<Value, 3> &colourRate() const { return m_rates; }

private:
    /// What is added to the vertex' value where that is a whole number: the quotient of a product.
    Value wholeAdded(const Value &added, Truncation kept) const
    {
        if (m_bugs.edgeStoring != Storing::AddedOfShorts || m_run == 0)
            return leftOf(added, kept);
        const Value run = Traits::fromLattice(m_run);
        const std::int64_t product = A::floor(added * run);
        return leftOf(Traits::fromInteger(std::int16_t(product)) / run, kept);
    }

    const ScanBugs &m_bugs;
    Value m_slope; ///< px per span
    Value m_along; ///< px
    bool m_isLevel = false; ///< the slope is 0
    Lattice m_vertex; ///< where the edge begins, along the span
    Colour m_vertexColour;
    Lattice m_run;
    std::array<Value, 3> m_levels, m_rates;
};

} // namespace pixelplumb
