// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/grade/pictures/picture.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// A picture of `side` × `side` px in sample coordinates from (0, 0) on, and tests that hold where
/// one triangle was drawn right.
class SampleView {
public:
    static constexpr int side = 32; // px

    /// Both must outlive the view.
    SampleView(const Scene &scene, const Picture &picture)
        : m_frame(scene.frame)
        , m_picture(picture)
    {
    }
    bool covers(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < side && y < side && m_picture.covered[placeOf(x, y)] != 0;
    }
    const Colour &colourAt(int x, int y) const { return m_picture.colours[placeOf(x, y)]; }
    /// A raster has no colours that could differ.
    bool hasColourAt(int x, int y, const Colour &colour) const
    {
        return !m_picture.hasColours || colourAt(x, y) == colour;
    }

    bool hasRuns() const; ///< each row and column has at most one covered run
    bool isWithinBoxOf(const Triangle &triangle) const;
    bool isWithinLevelsOf(const Triangle &triangle) const;
    /// A vertex on a covered sample has its colour there.
    bool hasCornersOf(const Triangle &triangle) const;
    /// For whole vertices, by Pick's theorem: I + B samples under the closed rule, I under the open
    /// one, between them under the others.
    bool hasCountOf(const Triangle &triangle, FillRule rule) const;

    /// Whether question(x, y) holds for every sample.
    template <class Question>
    static bool holdsEverywhere(const Question &question)
    {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (!question(x, y))
                    return false;
            }
        }
        return true;
    }

private:
    std::size_t placeOf(int x, int y) const
    {
        return m_picture.placeOf(x, pictureLine(m_frame, y));
    }

    const FrameSpec &m_frame;
    const Picture &m_picture;
};

} // namespace pixelplumb
