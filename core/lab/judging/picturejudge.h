// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/judging/labfigures.h"
#include "core/lab/judging/pixelwindow.h"
#include "core/scan/boundaryrule.h"

#include <optional>

namespace pixelplumb {

/// The true picture of one triangle on a frame, by the oracle.
struct TruePicture {
    TruePicture(const Triangle &of, const BoundaryRule &rule, ByteRounding rounding,
                const FrameView &frame);

    const Triangle *triangle;
    PixelWindow window; ///< the triangle's box, and what is next to it
    std::int64_t pixels = 0; ///< covered
};

/// The first triangle that a contender got wrong, and its lowest wrong pixel.
struct FirstMiss {
    Triangle triangle;
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// Compares pictures of single triangles with the truth and adds up the errors.
class PictureJudge {
public:
    /// Compares what was drawn, on a frame that was transparent, with the truth, in the samples of
    /// a box that holds the truth's window.
    void judge(const TruePicture &truth, const FrameView &drawn, const SampleBox &box);

    const AccuracyFigures &figures() const { return m_figures; }
    AccuracyFigures &figures() { return m_figures; }
    const std::optional<FirstMiss> &firstMiss() const { return m_firstMiss; }

private:
    void noteMissing(const TruePicture &truth, std::int64_t x, std::int64_t y);
    void noteExtra(const TruePicture &truth, std::int64_t x, std::int64_t y);
    void noteFirst(const TruePicture &truth, std::int64_t x, std::int64_t y);

    AccuracyFigures m_figures;
    std::optional<FirstMiss> m_firstMiss;
};

/// The errors of a finished picture of many triangles. Ties and distances are not distinguished:
/// every miss is missing or extra.
AccuracyFigures figuresOfPicture(const FrameView &truth, const FrameView &drawn);

} // namespace pixelplumb
