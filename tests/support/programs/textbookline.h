// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

/// How a program rounds halves: ⌊v + ½⌋, (int)(v + ½), lround, to even, ⌈v − ½⌉.
enum class Halves { Up, CutUp, Away, Even, Down };
inline constexpr std::array allHalves
    = {Halves::Up, Halves::CutUp, Halves::Away, Halves::Even, Halves::Down};

/// A line as textbooks draw it, in this number, without core code.
template <class Number>
class TextbookLine {
public:
    TextbookLine(const Shape &line, Halves halves, Picture &picture)
        : m_halves(halves)
        , m_picture(picture)
    {
        for (std::size_t i = 0; i < 2; ++i) {
            m_x[i] = int(line.vertices[i].position.x / unitsPerPixel);
            m_y[i] = int(line.vertices[i].position.y / unitsPerPixel);
            for (std::size_t channel = 0; channel < 3; ++channel)
                m_level[channel][i] = line.vertices[i].colour.channels[channel];
        }
    }

    void byAdding()
    {
        const int steps = longerSide();
        Number x = m_x[0];
        Number y = m_y[0];
        std::array<Number, 3> level = {};
        for (std::size_t i = 0; i < 3; ++i)
            level[i] = m_level[i][0];
        for (int k = 0; k <= steps; ++k) {
            plot(x, y, level);
            x += Number(m_x[1] - m_x[0]) / Number(std::max(steps, 1));
            y += Number(m_y[1] - m_y[0]) / Number(std::max(steps, 1));
            for (std::size_t i = 0; i < 3; ++i)
                level[i] += Number(m_level[i][1] - m_level[i][0]) / Number(std::max(steps, 1));
        }
    }
    void byEquation()
    {
        const std::size_t left = m_x[1] < m_x[0] ? 1 : 0;
        const std::size_t right = 1 - left;
        const int width = m_x[right] - m_x[left];
        const Number m = Number(m_y[right] - m_y[left]) / Number(width);
        const Number b = Number(m_y[left]) - m * Number(m_x[left]);
        for (int x = m_x[left]; width > 0 && x <= m_x[right]; ++x)
            plot(Number(x), m * Number(x) + b,
                 levelsAt(left, Number(x - m_x[left]) / Number(width)));
    }
    void byParameter()
    {
        const int steps = std::max(longerSide(), 1);
        Number t = 0;
        for (int k = 0; k <= steps; ++k) {
            plot(Number(m_x[0]) + t * Number(m_x[1] - m_x[0]),
                 Number(m_y[0]) + t * Number(m_y[1] - m_y[0]), levelsAt(0, t));
            t += Number(1) / Number(steps);
        }
    }

private:
    int longerSide() const
    {
        return std::max(std::abs(m_x[1] - m_x[0]), std::abs(m_y[1] - m_y[0]));
    }
    std::array<Number, 3> levelsAt(std::size_t from, Number share) const
    {
        std::array<Number, 3> level = {};
        for (std::size_t i = 0; i < 3; ++i)
            level[i] = Number(m_level[i][from])
                + share * Number(m_level[i][1 - from] - m_level[i][from]);
        return level;
    }
    int rounded(Number value) const
    {
        switch (m_halves) {
        case Halves::Up:
            return int(std::floor(value + Number(0.5)));
        case Halves::CutUp:
            return int(value + Number(0.5));
        case Halves::Away:
            return int(std::lround(value));
        case Halves::Even:
            return int(std::nearbyint(value));
        case Halves::Down:
            break;
        }
        return int(std::ceil(value - Number(0.5)));
    }
    void plot(Number x, Number y, const std::array<Number, 3> &level)
    {
        const std::size_t place = m_picture.placeOf(rounded(x), m_picture.height - 1 - rounded(y));
        m_picture.covered[place] = 1;
        for (std::size_t i = 0; i < 3; ++i)
            m_picture.colours[place].channels[i] = std::uint8_t(
                std::clamp(std::floor(level[i] + Number(0.5)), Number(0), Number(255)));
    }

    Halves m_halves;
    Picture &m_picture;
    std::array<int, 2> m_x = {}, m_y = {};
    std::array<std::array<int, 2>, 3> m_level = {};
};

template <class Number>
Picture textbookPicture(const Scene &scene, Halves halves)
{
    Picture picture = emptyPicture(scene.frame);
    for (const Shape &shape : scene.shapes) {
        TextbookLine<Number> line(shape, halves, picture);
        if (scene.method == "line-slope-intercept")
            line.byEquation();
        else if (scene.method == "line-parametric")
            line.byParameter();
        else
            line.byAdding();
    }
    return picture;
}

} // namespace pixelplumb
