// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/boundedside.h"

namespace pixelplumb {

namespace {

constexpr double walks = 2; // with errors: this one and the other program's

} // namespace

BoundedSide::BoundedSide(const Triangle &triangle, const RoundingSide &side)
    : m_side(side)
{
    const bool isExact = side.arithmetic == Arithmetic::Exact;
    const ArithmeticBound bound(triangle, isExact ? Arithmetic::Float64 : side.arithmetic);
    if (bound.isProved())
        m_bound = bound;
}

double BoundedSide::inward() const
{
    if (!m_bound)
        return 0;
    const double error = walks * m_bound->endError(SpanAxis::Column);
    return m_side.isOutward ? -error : error;
}

double BoundedSide::upward(double rate, double height) const
{
    if (!m_bound || m_side.arithmetic == Arithmetic::Exact)
        return 0;
    constexpr double any = 1024; // levels: beyond all bytes
    const double error = isThin(height) ? any : walks * m_bound->spanLevelError(rate);
    return m_side.isUpward ? error : -error;
}

double BoundedSide::carriedUpward(double rate, double height) const
{
    // The error of R where it begins, and where it ends.
    return isThin(height) ? 0 : 2 * upward(rate, height);
}

/// On a thin span the increment may be anything.
bool BoundedSide::isThin(double height) const
{
    return m_bound && height <= 4 * walks * m_bound->endError(SpanAxis::Column);
}

} // namespace pixelplumb
