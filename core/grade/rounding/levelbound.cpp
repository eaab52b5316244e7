// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/arithmeticbound.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

double heightOf(const oracle::ExactColumn &span)
{
    return span.yTop.toDouble() - span.yBottom.toDouble();
}

} // namespace

std::pair<int, int> LevelRange::bytes(ByteRounding rounding) const
{
    const double added = rounding == ByteRounding::Nearest ? 0.5 : 0;
    const auto byteOf
        = [added](double level) { return int(std::clamp(std::floor(level + added), 0.0, 255.0)); };
    return {byteOf(least), byteOf(most)};
}

std::optional<oracle::ExactColumn> ArithmeticBound::spanAt(SpanAxis walk, std::int64_t x,
                                                           std::int64_t y) const
{
    return walk == SpanAxis::Column ? oracle::columnAt(m_triangle, FillRule::Closed, x)
                                    : oracle::columnAt(m_exchanged, FillRule::Closed, y);
}

double ArithmeticBound::spanLevelError(double rate) const
{
    return 5 * (m_columnLevelError + std::abs(rate) * m_columnError)
        + (m_extent[1] + 7) * m_unit * levels;
}

bool ArithmeticBound::isThin(const oracle::ExactColumn &span, SpanAxis walk) const
{
    return heightOf(span) <= 4 * (walk == SpanAxis::Column ? m_columnError : m_rowError);
}

double ArithmeticBound::walkLevelError(SpanAxis walk, std::size_t channel) const
{
    const bool isByColumns = walk == SpanAxis::Column;
    const double levelError = isByColumns ? m_columnLevelError : m_rowLevelError;
    const double endsError = isByColumns ? m_columnError : m_rowError;
    const double rate = std::abs(m_gradient[channel][isByColumns ? 1 : 0]);
    const double steps = m_extent[isByColumns ? 1 : 0] + 1;
    return 5 * (levelError + rate * endsError) + (steps + 6) * m_unit * levels;
}

double ArithmeticBound::functionLevelError() const
{
    return levels * (16 * m_functionError / m_area + 16 * m_unit);
}

std::optional<double> ArithmeticBound::levelError(std::int64_t x, std::int64_t y,
                                                  std::size_t channel) const
{
    if (!m_isProved || m_area <= 2 * m_functionError)
        return std::nullopt;
    double error = functionLevelError();
    for (const SpanAxis walk : {SpanAxis::Column, SpanAxis::Row}) {
        const auto span = spanAt(walk, x, y);
        if (!span || isThin(*span, walk)) // its increment may be anything
            return std::nullopt;
        error = std::max(error, walkLevelError(walk, channel));
    }
    return error;
}

std::optional<LevelRange> ArithmeticBound::levelsAt(std::int64_t x, std::int64_t y,
                                                    std::size_t channel) const
{
    constexpr double ownError = 1e-9; // of these doubles
    const auto level = [&](std::size_t vertex) {
        return double(m_triangle.vertices[vertex].colour.channels[channel]);
    };
    const auto [least, most] = std::minmax({level(0), level(1), level(2)});
    if (m_largest > largestProved || (m_area != 0 && m_area <= 2 * m_functionError))
        return std::nullopt;
    if (m_area == 0) {
        const double error
            = 5 * std::max(m_columnLevelError, m_rowLevelError) + levels * 16 * m_unit;
        return LevelRange{least - error, most + error};
    }
    const double exact = oracle::colourAt(m_triangle, x, y)[channel].toDouble();
    LevelRange range{exact, exact};
    const auto include = [&range](double middle, double error) {
        range.least = std::min(range.least, middle - error - ownError);
        range.most = std::max(range.most, middle + error + ownError);
    };
    include(exact, functionLevelError());
    for (const SpanAxis walk : {SpanAxis::Column, SpanAxis::Row}) {
        const bool isByColumns = walk == SpanAxis::Column;
        const auto span = spanAt(walk, x, y);
        if (!span)
            continue; // no walk along this axis meets the sample
        if (!isThin(*span, walk)) {
            include(exact, walkLevelError(walk, channel));
            continue;
        }
        const double sample = double(isByColumns ? y : x);
        const double endError
            = 5 * (isByColumns ? m_columnLevelError : m_rowLevelError) + 8 * m_unit * levels;
        for (const double end : {span->yBottom.toDouble(), span->yTop.toDouble()}) {
            const double atEnd = exact + m_gradient[channel][isByColumns ? 1 : 0] * (end - sample);
            include(std::clamp(atEnd, least, most), endError);
        }
    }
    return range;
}

} // namespace pixelplumb
