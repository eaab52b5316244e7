// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"
#include "core/number/commonfraction.h"

namespace pixelplumb {

/// A scene's triangles on its samples, which are redrawn one by one, whole or only in chosen spans.
struct SeenTriangles {
    explicit SeenTriangles(const Scene &of, const ChosenSpans *in = nullptr)
        : scene(of)
        , chosen(in)
        , axis(methodNamed(QString::fromStdString(of.method))->spanAxis)
        , onSamples(primitivesOnSamples(of).triangles)
    {
    }

    const Scene &scene;
    const ChosenSpans *chosen; ///< null: all
    SpanAxis axis;
    std::vector<Triangle> onSamples;
};

/// One triangle of a scene, redrawn: its samples in painting order.
class RedrawnTriangle {
public:
    /// Changes the right picture, on a side of rounding if one is given. A walk draws everything
    /// itself and needs no right picture.
    RedrawnTriangle(const SeenTriangles &seen, std::size_t triangle, const Redrawing &redrawing,
                    std::function<Picture()> drawRight,
                    const std::optional<RoundingSide> &side = {});

    /// Draws only until as many samples as the limit differ from the picture found.
    RedrawnTriangle(const SeenTriangles &seen, std::size_t triangle, const Redrawing &redrawing,
                    const Picture &found, std::int64_t limit);
    bool isRefused() const { return m_runs.isRefused; }

    void paintOn(Picture &picture, Repainting repainting, const Colour &background) const;

private:
    void see(const SeenTriangles &seen, std::size_t place, VisitedBox box);
    /// A run's samples in the frame, and where the first one and each next one is in a picture.
    struct RunPlaces {
        std::int64_t first = 0, end = 0;
        std::size_t index = 0;
        std::size_t stride = 0; ///< modulo 2^64, as lines may ascend
    };
    RunPlaces placesOf(const SampleRun &run) const;
    std::int64_t differingIn(const Picture &found, const SampleRun &run) const;
    const Picture &right() const;
    std::optional<std::size_t> indexOf(std::int64_t span, std::int64_t place) const;
    void readRuns();
    std::uint8_t byteOf(std::int64_t level) const;
    Colour colourAt(const SampleRun &run, std::int64_t place, std::size_t index) const;
    WholeLevels levelsOf(const Colour &colour) const;
    std::int64_t wholeLevelOf(const CommonFraction &exact) const;
    WholeLevels planeAt(std::int64_t span, std::int64_t place) const;

    FrameSpec m_frame;
    LevelOverflow m_overflow;
    LevelBytes m_bytes;
    bool m_goesByRows = false;
    std::function<Picture()> m_drawRight;
    mutable std::optional<Picture> m_right; ///< drawn on first use
    TriangleRuns m_runs;
};

} // namespace pixelplumb
