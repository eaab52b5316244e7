// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

/// What is wrong in a student's Bresenham.
enum class LineMistake {
    None,
    NoFirstPixel,
    NoLeastPixel,
    NoLastPixel,
    TwiceRiseFirst,
    DifferenceFirst,
    ZeroFirst,
    MinusDxFirst,
    ExchangedFirst,
    OneRise, ///< p += Δy
    OneRun, ///< p += 2Δy − Δx
    OneDifference, ///< p += Δy − Δx
    NeverLowered, ///< p += 2Δy
    LoweredAlone, ///< p −= 2Δx
    WrongSign,
    NotExchangedBack, ///< setPixel(x, y), even of a steep line
    NoSteepLines,
    NeverDown, ///< Δy < 0, so that p is never positive
    TwiceDifferenceFirst,
    HalvedSteps, ///< p += Δy, p += Δy − Δx
    ExchangedSteps,
    SteppedTwice, ///< 2Δy always, and 2Δy − 2Δx in addition
    SteppedBefore, ///< p += 2Δy, then p is tested
    SetBack, ///< p = 2Δy − Δx where it steps across
    OnePast, ///< k ≤ Δx + 1
    UpwardLoop, ///< for (x = x₀; x <= x₁; ++x)
    WrongWay,
    DividedByPixels, ///< (C₁ − C₀)/(Δx + 1)
    OneAhead, ///< the colour of k + 1
    SteepnessInverted, ///< if (abs(Δy) < abs(Δx)) x and y are exchanged
    WholeSlope, ///< y += Δy / Δx of whole numbers
};
/// Whether the left end point is stored in (x₀, y₀).
enum class LineEnds { LeftFirst, AsGiven };
/// What happens at p = 0: the slides step at p ≥ 0, other texts at p > 0.
enum class LineTie { StepsAcross, Stays };

/// One line in whole coordinates, drawn by the slides' steps alone, with no core code.
class StudentLine {
public:
    StudentLine(const Shape &line, LineMistake mistake, LineEnds ends, LineTie tie)
        : m_mistake(mistake)
        , m_tie(tie)
    {
        for (std::size_t i = 0; i < 2; ++i) {
            m_x[i] = int(line.vertices[i].position.x / unitsPerPixel);
            m_y[i] = int(line.vertices[i].position.y / unitsPerPixel);
            m_colour[i] = line.vertices[i].colour;
        }
        m_isSteep = std::abs(m_y[1] - m_y[0]) >= std::abs(m_x[1] - m_x[0]);
        if (mistake == LineMistake::SteepnessInverted)
            m_isSteep = !m_isSteep;
        if (m_isSteep)
            std::swap(m_x, m_y);
        // "Store left line endpoint in (x₀, y₀)"
        m_isSwapped = ends == LineEnds::LeftFirst && m_x[1] < m_x[0];
        if (m_isSwapped) {
            std::swap(m_x[0], m_x[1]);
            std::swap(m_y[0], m_y[1]);
            std::swap(m_colour[0], m_colour[1]);
        }
    }

    void paintOn(Picture &picture) const
    {
        const int dx = std::abs(m_x[1] - m_x[0]);
        const int dy = std::abs(m_y[1] - m_y[0]);
        if (m_mistake == LineMistake::NoSteepLines && m_isSteep)
            return;
        int p = firstDecision(dx, dy);
        int y = m_y[0];
        if (m_mistake == LineMistake::UpwardLoop && m_x[1] < m_x[0])
            return;
        const int last = m_mistake == LineMistake::OnePast ? dx + 1 : dx;
        for (int k = 0; k <= last; ++k) {
            const int x = m_x[0] + (m_x[1] < m_x[0] ? -k : k);
            const bool isLeftOut = m_mistake == LineMistake::NoLeastPixel ? k == 0
                : m_mistake == LineMistake::NoFirstPixel ? k == (m_isSwapped ? dx : 0)
                : m_mistake == LineMistake::NoLastPixel  ? k == (m_isSwapped ? 0 : dx)
                                                         : false;
            if (!isLeftOut)
                paint(picture, x, y, colourAt(k, dx));
            const bool isBefore = m_mistake == LineMistake::SteppedBefore;
            if (isBefore)
                p += 2 * dy;
            const bool isFlat = m_mistake == LineMistake::NeverDown && m_y[1] < m_y[0];
            const int leastAcross = m_tie == LineTie::Stays ? 1 : 0;
            const bool crosses
                = m_mistake == LineMistake::WrongSign ? p < 0 : p >= leastAcross && !isFlat;
            const bool isWhole = m_mistake == LineMistake::WholeSlope;
            const bool goesDown = (m_y[1] < m_y[0]) != (m_mistake == LineMistake::WrongWay);
            if (isWhole ? dy == dx : crosses)
                y += goesDown ? -1 : 1;
            if (m_mistake == LineMistake::SteppedTwice && crosses)
                p += 2 * dy;
            p += (crosses ? whereItCrosses(dx, dy) : whereItStays(dx, dy))
                - (isBefore ? 2 * dy : 0);
            if (m_mistake == LineMistake::SetBack && crosses)
                p = firstDecision(dx, dy);
        }
    }

private:
    int firstDecision(int dx, int dy) const
    {
        switch (m_mistake) {
        case LineMistake::TwiceRiseFirst:
            return 2 * dy;
        case LineMistake::DifferenceFirst:
            return dy - dx;
        case LineMistake::TwiceDifferenceFirst:
            return 2 * dy - 2 * dx;
        case LineMistake::ZeroFirst:
            return 0;
        case LineMistake::MinusDxFirst:
            return -dx;
        case LineMistake::ExchangedFirst:
            return 2 * dx - dy;
        default:
            return 2 * dy - dx;
        }
    }
    int whereItStays(int dx, int dy) const
    {
        switch (m_mistake) {
        case LineMistake::OneRise:
        case LineMistake::HalvedSteps:
            return dy;
        case LineMistake::ExchangedSteps:
            return 2 * dy - 2 * dx;
        default:
            return 2 * dy;
        }
    }
    int whereItCrosses(int dx, int dy) const
    {
        switch (m_mistake) {
        case LineMistake::HalvedSteps:
            return dy - dx;
        case LineMistake::ExchangedSteps:
            return 2 * dy;
        case LineMistake::OneRun:
            return 2 * dy - dx;
        case LineMistake::OneDifference:
            return dy - dx;
        case LineMistake::NeverLowered:
            return 2 * dy;
        case LineMistake::LoweredAlone:
            return -2 * dx;
        default:
            return 2 * dy - 2 * dx;
        }
    }
    void paint(Picture &picture, int x, int y, const Colour &colour) const
    {
        if (m_isSteep && m_mistake != LineMistake::NotExchangedBack)
            std::swap(x, y);
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
            return;
        const std::size_t place = picture.placeOf(x, picture.height - 1 - y);
        picture.colours[place] = colour;
        picture.covered[place] = 1;
    }
    Colour colourAt(int k, int dx) const
    {
        Colour colour;
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = m_colour[0].channels[i];
            const int steps = m_mistake == LineMistake::OneAhead ? k + 1 : k;
            const int divisor = m_mistake == LineMistake::DividedByPixels ? dx + 1 : dx;
            const int rise = (m_colour[1].channels[i] - from) * steps;
            const double level = dx == 0 ? from : from + double(rise) / divisor;
            colour.channels[i] = std::uint8_t(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
        }
        return colour;
    }

    LineMistake m_mistake;
    LineTie m_tie;
    std::array<int, 2> m_x = {}, m_y = {};
    std::array<Colour, 2> m_colour;
    bool m_isSteep = false, m_isSwapped = false;
};

inline Picture studentPicture(const Scene &scene, LineMistake mistake, LineEnds ends,
                              LineTie tie = LineTie::StepsAcross)
{
    Scene empty = scene;
    empty.shapes.clear();
    Picture picture = pictureOf(empty);
    for (const Shape &line : scene.shapes)
        StudentLine(line, mistake, ends, tie).paintOn(picture);
    return picture;
}

} // namespace pixelplumb
