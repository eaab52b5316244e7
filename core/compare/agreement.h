// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"

#include <QString>

#include <array>
#include <vector>

namespace pixelplumb {

/// Why contenders disagree on a pixel. Where several reasons apply, the latest in this list is
/// reported.
enum class Disagreement : std::uint8_t {
    None, ///< they agree
    TieRule, ///< they use different fill rules, and the sample lies exactly on an edge
    Undrawn, ///< a primitive of a kind that one of the methods does not draw covers the pixel
    Rounding, ///< the coverage is the same; a byte is off by one, from a level close to a rounding
              ///< limit
    Drift, ///< accumulated increments are off, although the start and the number type are good
    Precision, ///< the number type cannot hold the deciding number
    Method, ///< the method itself, in any arithmetic: the gaps of slope-intercept lines
    NotRecorded, ///< a recording ended at its limit before the pixel
};

inline constexpr std::array allDisagreements = {
    Disagreement::TieRule,   Disagreement::Undrawn, Disagreement::Rounding,   Disagreement::Drift,
    Disagreement::Precision, Disagreement::Method,  Disagreement::NotRecorded};

/// "tie rule", "rounding", …
QString nameOf(Disagreement reason);
/// One sentence.
QString textOf(Disagreement reason);

/// For each pixel, how many contenders agree: the size of the largest group with the same pixel,
/// which is all of them where none draws.
class AgreementMap {
public:
    AgreementMap() = default;
    AgreementMap(const FrameSpec &spec, int contenderCount)
        : m_contenderCount(contenderCount)
        , m_pixels(spec, {std::uint8_t(contenderCount), Disagreement::None})
        , m_byAgreeing(std::size_t(contenderCount) + 1, 0)
    {
        m_byAgreeing.back() = std::int64_t(m_pixels.size());
        m_byReason[std::size_t(Disagreement::None)] = std::int64_t(m_pixels.size());
    }

    const FrameSpec &spec() const { return m_pixels.spec(); }
    int contenderCount() const { return m_contenderCount; }

    /// All contenders outside the frame.
    int agreeingAt(std::int64_t x, std::int64_t y) const
    {
        return m_pixels.contains(x, y) ? m_pixels.at(x, y).agreeing : m_contenderCount;
    }
    /// Disagreement::None outside the frame.
    Disagreement reasonAt(std::int64_t x, std::int64_t y) const
    {
        return m_pixels.contains(x, y) ? m_pixels.at(x, y).reason : Disagreement::None;
    }
    /// (x, y) must lie inside the frame.
    void set(std::int64_t x, std::int64_t y, int agreeing, Disagreement reason);

    /// The number of pixels on which this many contenders agree.
    std::int64_t countAgreeing(int agreeing) const { return m_byAgreeing[std::size_t(agreeing)]; }
    std::int64_t count(Disagreement reason) const { return m_byReason[std::size_t(reason)]; }
    /// The number of pixels on which not all agree.
    std::int64_t differing() const { return std::int64_t(m_pixels.size()) - m_byAgreeing.back(); }

private:
    struct Pixel {
        std::uint8_t agreeing;
        Disagreement reason;
    };

    int m_contenderCount = 0;
    FrameMap<Pixel> m_pixels;
    std::vector<std::int64_t> m_byAgreeing = {0};
    std::array<std::int64_t, allDisagreements.size() + 1> m_byReason = {};
};

} // namespace pixelplumb
