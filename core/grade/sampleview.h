// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/grade/picture.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// A picture of `side` × `side` px by sample coordinates from (0, 0) on, and what holds of it where
/// one triangle was drawn right.
class SampleView {
public:
    static constexpr int side = 32; // px

    /// Both outlive the view.
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

    bool hasRuns() const; ///< each row and column is covered in one run at most
    bool isWithinBoxOf(const Triangle &triangle) const;
    bool isWithinLevelsOf(const Triangle &triangle) const;
    /// A vertex on a sample that is covered has its colour there.
    bool hasCornersOf(const Triangle &triangle) const;
    /// Of whole vertices, by Pick's theorem: I + B samples under the closed rule, I under the open
    /// one, between them under the others.
    bool hasCountOf(const Triangle &triangle, FillRule rule) const;

    /// Whether question(x, y) is true of every sample.
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
