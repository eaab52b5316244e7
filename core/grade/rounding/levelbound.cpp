// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/arithmeticbound.h"
#include "core/oracle/oracle.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// The height of the triangle along a column, px; 0 outside it.
double heightAt(const Triangle &triangle, std::int64_t x)
{
    const auto column = oracle::columnAt(triangle, FillRule::Closed, x);
    return column ? column->yTop.toDouble() - column->yBottom.toDouble() : 0;
}

} // namespace

std::pair<int, int> LevelRange::bytes(ByteRounding rounding) const
{
    const double added = rounding == ByteRounding::Nearest ? 0.5 : 0;
    const auto byteOf
        = [added](double level) { return int(std::clamp(std::floor(level + added), 0.0, 255.0)); };
    return {byteOf(least), byteOf(most)};
}

double ArithmeticBound::spanLevelError(double rate) const
{
    return 5 * (m_columnLevelError + std::abs(rate) * m_columnError)
        + (m_extent[1] + 7) * m_unit * levels;
}

std::optional<double> ArithmeticBound::levelError(std::int64_t x, std::int64_t y,
                                                  std::size_t channel) const
{
    // On a thin span the increment may be anything.
    const bool isThin = !m_isProved || heightAt(m_triangle, x) <= 4 * m_columnError
        || heightAt(m_exchanged, y) <= 4 * m_rowError || m_area <= 2 * m_functionError;
    if (isThin)
        return std::nullopt;
    const auto [alongX, alongY] = m_gradient[channel];
    const auto walked = [&](double levelError, double gradient, double boundError, double steps) {
        return 5 * (levelError + std::abs(gradient) * boundError) + (steps + 6) * m_unit * levels;
    };
    const double byColumns = walked(m_columnLevelError, alongY, m_columnError, m_extent[1] + 1);
    const double byRows = walked(m_rowLevelError, alongX, m_rowError, m_extent[0] + 1);
    const double byFunctions = levels * (16 * m_functionError / m_area + 16 * m_unit);
    return std::max({byColumns, byRows, byFunctions});
}

std::optional<LevelRange> ArithmeticBound::levelsAt(std::int64_t x, std::int64_t y,
                                                    std::size_t channel) const
{
    constexpr double ownError = 1e-9; // of these doubles
    if (const auto error = levelError(x, y, channel)) {
        const double exact = oracle::colourAt(m_triangle, x, y)[channel].toDouble();
        return LevelRange{exact - *error - ownError, exact + *error + ownError};
    }
    const bool isThinnerThanHeld = m_area != 0 && m_area <= 2 * m_functionError;
    if (isThinnerThanHeld || m_largest > largestProved)
        return std::nullopt;
    const auto level = [&](std::size_t vertex) {
        return double(m_triangle.vertices[vertex].colour.channels[channel]);
    };
    const auto [least, most] = std::minmax({level(0), level(1), level(2)});
    const double ofFunctions = m_area != 0 ? 16 * m_functionError / m_area : 0;
    const double error
        = 5 * std::max(m_columnLevelError, m_rowLevelError) + levels * (ofFunctions + 16 * m_unit);
    return LevelRange{least - error, most + error};
}

} // namespace pixelplumb
