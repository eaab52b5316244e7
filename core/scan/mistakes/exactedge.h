// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/exacttrack.h"
#include "core/scan/mistakes/walkedprogram.h"

#include <bit>

namespace pixelplumb {

/// Where an edge meets the current span, in fractions.
class ExactEdge {
public:
    ExactEdge(const WalkedEdge &edge, const ScanBugs &bugs, std::int64_t span)
        : m_bugs(bugs)
    {
        const Lattice grid = gridOf(edge);
        const Lattice width = edge.places.b.position.x - edge.places.a.position.x;
        const Lattice rise = edge.places.b.position.y - edge.places.a.position.y;
        m_places = trackOf({edge.firstPlace.position.y, rise, bugs.slopes}, width,
                           span * unitsPerPixel - edge.firstPlace.position.x, grid);
        const Lattice ofColours = edge.colours.b.position.x - edge.colours.a.position.x;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t source = sourceOf(i, bugs.ratesAlongEdgesOf);
            const int change
                = edge.colours.b.colour.channels[source] - edge.colours.a.colour.channels[source];
            const int first = edge.firstColour.colour.channels[i];
            m_levels[i]
                = trackOf({first * unitsPerPixel, change * unitsPerPixel, bugs.edgeColours},
                          ofColours, wayToSpan(edge.firstColour.position.x, span, bugs, i), grid);
        }
        if (bugs.edgeStoring == Storing::FromFirst) {
            m_places.store(bugs.edgePlaces);
            for (ExactTrack &level : m_levels)
                level.store(bugs.edgeLevels);
        }
        const std::array<ExactTrack, 3> own = m_levels; // share one denominator
        for (std::size_t i = 0; i < 3; ++i) {
            m_levels[i].rate = own[sourceOf(i, bugs.stepsAlongEdgesOf)].rate;
            if (bugs.unsteppedAlongEdges.contains(i))
                m_levels[i].rate = 0;
        }
    }

    const ExactTrack &track() const { return m_places; } ///< px
    MixedNumber<Int128> place() const { return mixedNumber(m_places.at, m_places.denominator); }
    const ExactTrack &level(std::size_t channel) const { return m_levels[channel]; }

    MixedNumber<Int128> slope() const { return mixedNumber(m_places.rate, m_places.denominator); }
    std::array<MixedNumber<Int128>, 3> colour() const
    {
        return threeOf(
            [&](std::size_t i) { return mixedNumber(m_levels[i].at, m_levels[i].denominator); });
    }
    std::array<MixedNumber<Int128>, 3> colourRate() const
    {
        return threeOf(
            [&](std::size_t i) { return mixedNumber(m_levels[i].rate, m_levels[i].denominator); });
    }

    void stepPlace() { m_places.step(m_bugs.edgePlaces); }
    void stepColour()
    {
        for (ExactTrack &level : m_levels)
            level.step(m_bugs.edgeLevels);
    }

    void carryPlaceOf(const ExactEdge &other) { m_places.carryOn(other.m_places); }
    void carryColourOf(const ExactEdge &other)
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_levels[i].carryOn(other.m_levels[i]);
    }
    void goOnWithPlacesOf(const ExactEdge &other) { m_places = other.m_places; }
    void goOnWithColoursOf(const ExactEdge &other) { m_levels = other.m_levels; }
    /// Steps from here on like another edge with the same denominators.
    void stepAsPlacesOf(const ExactEdge &other) { m_places.rate = other.m_places.rate; }
    void stepAsColoursOf(const ExactEdge &other)
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_levels[i].rate = other.m_levels[i].rate;
    }
    void holdPlace() { m_places.rate = 0; }
    void holdColour()
    {
        for (ExactTrack &level : m_levels)
            level.rate = 0;
    }

    bool isBelow(const ExactEdge &other) const
    {
        return m_places.at * other.m_places.denominator < other.m_places.at * m_places.denominator;
    }
    std::int64_t floor() const { return std::int64_t(m_places.floor()); }
    std::int64_t ceil() const { return std::int64_t(m_places.ceil()); }
    std::int64_t nearest() const
    {
        return std::int64_t(leftOf<Int128>(m_places.at, m_places.denominator, Truncation::Nearest));
    }

private:
    /// A value that is stepped from a vertex on, in 1/256 px or 1/256 level, and its change up to
    /// the other vertex.
    struct Change {
        Int128 from, by;
        Truncation kept; ///< of the quotient
    };
    /// The widest grid, in lattice units, that holds all positions: dividing by it at once keeps
    /// numbers small, which makes later divisions much faster.
    static Lattice gridOf(const WalkedEdge &edge)
    {
        const std::array<LatticePoint, 6> places
            = {edge.places.a.position,  edge.places.b.position,  edge.firstPlace.position,
               edge.colours.a.position, edge.colours.b.position, edge.firstColour.position};
        std::uint64_t bits = unitsPerPixel;
        for (const LatticePoint &place : places)
            bits |= std::uint64_t(place.x) | std::uint64_t(place.y);
        return Lattice(1) << std::countr_zero(bits);
    }

    /// The track `way` lattice units from the vertex; all lengths are on the grid. An edge along
    /// the spans stays at the vertex.
    static ExactTrack trackOf(Change change, Lattice width, Lattice way, Lattice grid)
    {
        if (width == 0)
            return {change.from, 0};
        change.from /= grid;
        change.by /= grid;
        way /= grid;
        Int128 divisor = width / grid;
        if (width < 0) {
            divisor = -divisor;
            change.by = -change.by;
        }
        if (change.kept != Truncation::All)
            change.by = leftOf<Int128>(change.by, divisor, change.kept) * divisor;
        const Lattice inPixel = unitsPerPixel / grid;
        return {change.from * divisor + way * change.by, change.by * inPixel, divisor * inPixel};
    }

    const ScanBugs &m_bugs;
    ExactTrack m_places;
    std::array<ExactTrack, 3> m_levels;
};

} // namespace pixelplumb
