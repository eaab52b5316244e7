// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picturerange.h"
#include "core/methods/method.h"
#include "core/scan/boundaryrule.h"
#include "core/scan/edgeteststate.h"
#include "core/scan/interval.h"

#include <functional>
#include <memory>
#include <optional>

namespace pixelplumb {

/// From which end the spans of a triangle are gone through: a right program draws the same from
/// either.
enum class SpanOrder { Ascending, Descending };

/// An interval seen from its other end.
constexpr Interval reversed(Interval interval)
{
    if (interval == Interval::ClosedOpen)
        return Interval::OpenClosed;
    return interval == Interval::OpenClosed ? Interval::ClosedOpen : interval;
}

/// R G B of a sample, rounded, before it is clamped.
using WholeLevels = std::array<std::int64_t, 3>;

/// The samples of one column or, where a program goes by rows, row.
struct SampleRun {
    std::int64_t span = 0; ///< x of a column, y of a row
    std::int64_t first = 0, end = 0; ///< of the other coordinate
    /// Of its samples one by one, which all lie in the frame then; empty: the method's own, and
    /// beyond what it draws those of the plane.
    std::vector<WholeLevels> levels = {};
    std::int64_t firstLevelled = 0; ///< the sample that has the first of these
};

/// One triangle as it is gone through: `triangle` has x and y exchanged where that is by rows.
struct TriangleRuns {
    Triangle triangle;
    SpanOrder order = SpanOrder::Ascending; ///< the method's
    ScanIntervals intervals; ///< of its spans, ascending, and of its samples
    ScanSettings settings;
    BoundaryRule rule = FillRule::Closed;
    SampleBox visited; ///< the bounding box as the program has it rounded; x is a column
    std::int64_t firstSpan = 0, endSpan = 0; ///< that the frame has
    std::int64_t firstSample = 0, endSample = 0; ///< that the frame has of a span
    std::vector<SampleRun> runs; ///< in the order in which they are painted
    std::optional<RoundingSide> side = {}; ///< on which of these a walk is to draw; none: its own
    /// Whether a run that nothing is painted over may be so; none: any may. A walk ends at one that
    /// may not.
    std::function<bool(const SampleRun &run)> mayBe = {};
    bool isRefused = false; ///< it has ended so
};

/// A triangle with x and y exchanged.
Triangle exchanged(Triangle triangle);

/// What becomes of a level outside 0 … 255.
enum class LevelOverflow { Clamps, Wraps };
/// What becomes of a pixel that is painted twice: the later one stands, or none.
enum class Repainting { Over, Toggles };

/// To which whole number a level is taken: as the scene says, ⌊ ⌋, the nearest or ⌈ ⌉.
enum class LevelRounding { OfScene, Down, Nearest, Up };
/// How levels, 0 … 255 here, become bytes; where this is not as it should be, of all samples, those
/// of the triangle's plane.
struct LevelBytes {
    int full = 255; ///< what a level of `of` is taken to
    LevelRounding rounding = LevelRounding::OfScene;
    int most = 255; ///< to which is clamped
    int of = 255;

    bool isRight() const { return *this == LevelBytes(); }
    friend bool operator==(const LevelBytes &, const LevelBytes &) = default;
};

/// Which samples are asked whether they are inside: those of the scene's bounding box, or those
/// from ⌊x_min⌋ to ⌈x_max⌉ and from ⌊y_min⌋ to ⌈y_max⌉.
enum class VisitedBox { OfScene, Outward };

struct ProgramWalk;
struct ProgramEdgeTest;

struct Redrawing {
    std::function<void(TriangleRuns &triangle)> change;
    LevelOverflow overflow = LevelOverflow::Clamps;
    Repainting repainting = Repainting::Over;
    LevelBytes bytes = {};
    std::shared_ptr<const ProgramWalk> walk = {}; ///< where the change is to go through it so alone
    std::shared_ptr<const ProgramEdgeTest> edgeTest = {}; ///< where it is to test samples so
    VisitedBox box = VisitedBox::OfScene;
};

/// What a program does that does both; none where they decide the same thing. One that goes through
/// the triangle, or tests its samples, does so first, then the other leaves samples out.
std::optional<Redrawing> together(const Redrawing &one, const Redrawing &other);

/// The scene of triangles, each drawn by the scene's method and changed.
Picture redrawn(const Scene &scene, const Redrawing &redrawing);

/// Whether the picture of a scene that is redrawn so cannot be the one that was found, as far as is
/// seen before it is drawn: by the last triangle of a walk, over which nothing is painted.
bool differsAtOnce(const Scene &scene, const Redrawing &redrawing, const Picture &found);

/// What programs draw that do the same in arithmetic up to this one. The scene's own is not asked.
PictureRange redrawnRange(const Scene &scene, const Redrawing &redrawing, Arithmetic arithmetic);
/// Whether a scene can be redrawn: it has triangles alone, not too many, and needs colours alone.
bool canBeRedrawn(const Scene &scene);

/// The scene with one of its triangles or shapes alone.
Scene triangleAlone(const Scene &scene, std::size_t triangle);
Scene shapeAlone(const Scene &scene, std::size_t shape);

} // namespace pixelplumb
