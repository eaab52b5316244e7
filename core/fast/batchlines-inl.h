// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a vector of triangles as bounds of spans. Compiled once for each instruction set.
#include "core/fast/boundinglines.h"
#include "core/fast/pixelvectors-inl.h"
#include "core/scan/scansettings.h"

#if defined(PIXELPLUMB_BATCHLINES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHLINES_INL
#undef PIXELPLUMB_BATCHLINES_INL
#else
#define PIXELPLUMB_BATCHLINES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Whether an edge owns the samples on it under the half-open rule: perRow > 0 or (perRow == 0 and
/// perColumn > 0). One sum decides, since |perColumn| < 2^25 and perRow is an integer.
template <class Reals>
HWY_INLINE hn::Mask<Reals> ownsItsSamples(Reals reals, hn::Vec<Reals> perRow,
                                          hn::Vec<Reals> perColumn)
{
    const auto side = hn::Add(hn::Mul(perRow, hn::Set(reals, 0x1p25)), perColumn);
    return hn::Gt(side, hn::Zero(reals));
}

/// Computes the lines of BoundingLines for a vector of triangles, each along its own axis: an
/// interval of rows in each column, as in the assignment, or an interval of columns in each row.
/// Both give the same samples.
template <FillRule Rule, class Reals>
class BatchLines {
    using Real = hn::Vec<Reals>;
    using Mask = hn::Mask<Reals>;

public:
    /// `sign`: the sign of the area. `spansRows`: where lines run over rows.
    BatchLines(TriangleBatch &batch, std::size_t i, Real sign, Mask spansRows)
        : m_batch(batch)
        , m_i(i)
        , m_sign(sign)
        , m_spansRows(spansRows)
    {
    }

    void run()
    {
        const Line line0 = lineOf(0, 1);
        const Line line1 = lineOf(1, 2);
        const Line line2 = lineOf(2, 0);
        // There are two lower bounds and one upper, or one and two, or one of each and an edge
        // parallel to the spans, so the first and the last of each kind are all there are.
        store(hn::Gt(line0.lead, zero()), hn::Gt(line1.lead, zero()), hn::Gt(line2.lead, zero()), 0,
              line0, line1, line2);
        store(hn::Lt(line0.lead, zero()), hn::Lt(line1.lead, zero()), hn::Lt(line2.lead, zero()), 2,
              line0, line1, line2);
    }

private:
    static constexpr Reals reals{};
    static Real zero() { return hn::Zero(reals); }
    static Real real(double value) { return hn::Set(reals, value); }

    struct Line {
        Real lead; ///< > 0: begins spans; < 0: ends them; 0: parallel to them
        Real constant;
        Real slope;
    };

    Real loaded(const TriangleBatch::Array<std::int32_t> &array) const
    {
        constexpr hn::Rebind<std::int32_t, Reals> integers{};
        return hn::PromoteTo(reals, hn::Load(integers, array.data() + m_i));
    }

    Line lineOf(std::size_t a, std::size_t b) const
    {
        const Real xa = loaded(m_batch.x[a]);
        const Real ya = loaded(m_batch.y[a]);
        const Real dx = hn::Sub(loaded(m_batch.x[b]), xa);
        const Real dy = hn::Sub(loaded(m_batch.y[b]), ya);
        const Real run = hn::IfThenElse(m_spansRows, dy, dx);
        const Real rise = hn::IfThenElse(m_spansRows, dx, dy);
        const Real along = hn::IfThenElse(m_spansRows, ya, xa);
        const Real across = hn::IfThenElse(m_spansRows, xa, ya);
        const Real perColumn = hn::Neg(hn::Mul(m_sign, dy));
        const Real perRow = hn::Mul(m_sign, dx);
        const Real lead = hn::IfThenElse(m_spansRows, perColumn, perRow);
        // −1/2 where the edge begins spans and owns its samples, or ends them and does not.
        Real bias = hn::CopySign(real(0.5), hn::Neg(lead));
        if constexpr (Rule != FillRule::Closed)
            bias = hn::IfThenElse(ownsItsSamples(reals, perRow, perColumn), bias, hn::Neg(bias));
        const Real inverse = hn::Div(real(1), run);
        const Real numerator = hn::Sub(hn::Mul(across, run), hn::Mul(along, rise));
        const Real positive = hn::Abs(inverse);
        const Real directed = hn::IfThenElse(hn::Lt(run, zero()), hn::Neg(numerator), numerator);
        return {lead,
                hn::Mul(hn::Add(directed, bias), hn::Mul(positive, real(1.0 / unitsPerPixel))),
                hn::Mul(rise, inverse)};
    }

    void store(Mask is0, Mask is1, Mask is2, std::size_t which, const Line &line0,
               const Line &line1, const Line &line2)
    {
        const auto put = [&](auto member, TriangleBatch::Array<double> &first,
                             TriangleBatch::Array<double> &last) HWY_ATTR {
            hn::Store(hn::IfThenElse(is0, line0.*member,
                                     hn::IfThenElse(is1, line1.*member, line2.*member)),
                      reals, first.data() + m_i);
            hn::Store(hn::IfThenElse(is2, line2.*member,
                                     hn::IfThenElse(is1, line1.*member, line0.*member)),
                      reals, last.data() + m_i);
        };
        put(&Line::constant, m_batch.lineConstant[which], m_batch.lineConstant[which + 1]);
        put(&Line::slope, m_batch.lineSlope[which], m_batch.lineSlope[which + 1]);
    }

    TriangleBatch &m_batch;
    std::size_t m_i;
    Real m_sign;
    Mask m_spansRows;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
