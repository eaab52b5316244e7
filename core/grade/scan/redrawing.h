// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/chosenspans.h"
#include "core/grade/pictures/picturerange.h"
#include "core/methods/method.h"
#include "core/scan/boundaryrule.h"
#include "core/scan/mistakes/walkedtriangle.h"
#include "core/scan/tests/edgeteststate.h"

#include <functional>
#include <memory>
#include <optional>

namespace pixelplumb {

/// The samples of one column, or one row for a program that goes by rows.
struct SampleRun {
    std::int64_t span = 0; ///< x of a column, y of a row
    std::int64_t first = 0, end = 0; ///< in the other coordinate
    /// The levels of its samples, which then all lie in the frame; empty: the method's own, and
    /// those of the plane where the method draws nothing.
    std::vector<WholeLevels> levels = {};
    std::int64_t firstLevelled = 0; ///< the sample that the first of these belongs to
};

/// One triangle as it is drawn; `triangle` has x and y exchanged when the walk goes by rows.
struct TriangleRuns : WalkedTriangle {
    BoundaryRule rule = FillRule::Closed;
    SampleBox visited; ///< the bounding box as the program rounds it; x is a column
    std::vector<SampleRun> runs; ///< in painting order
    std::function<void()> readRight = {}; ///< makes the runs those of the right picture
    const ChosenSpans *chosen = nullptr; ///< no others are asked for; null: all are
    std::optional<RoundingSide> side = {}; ///< the walk's side of rounding; none: its own numbers
    /// Whether the walk goes on after a run that nothing paints over later; none: always.
    std::function<bool(const SampleRun &run)> mayBe = {};
    bool isRefused = false; ///< the walk ended there

    bool isAskedFor(std::int64_t span) const { return !chosen || chosen->contains(span); }
};

/// A triangle with x and y exchanged.
Triangle exchanged(Triangle triangle);

/// What a pixel painted twice shows: the later colour, or nothing.
enum class Repainting { Over, Toggles };

/// How a level becomes a whole number: as in the scene, ⌊ ⌋, to nearest or ⌈ ⌉.
enum class LevelRounding { OfScene, Down, Nearest, Up };
/// How levels, here 0 … 255, become bytes; if not as usual, this applies to all samples, with the
/// levels of the triangle's plane.
struct LevelBytes {
    int full = 255; ///< what a level of `of` becomes
    LevelRounding rounding = LevelRounding::OfScene;
    int most = 255; ///< the upper limit of clamping
    int of = 255;

    bool isRight() const { return *this == LevelBytes(); }
    friend bool operator==(const LevelBytes &, const LevelBytes &) = default;
};

/// Which samples are tested: those of the scene's bounding box, or those from ⌊x_min⌋ to ⌈x_max⌉
/// and from ⌊y_min⌋ to ⌈y_max⌉.
enum class VisitedBox { OfScene, Outward };

struct Redrawing {
    std::function<void(TriangleRuns &triangle)> change;
    LevelOverflow overflow = LevelOverflow::Clamps;
    Repainting repainting = Repainting::Over;
    LevelBytes bytes = {};
    std::shared_ptr<const ScanBugs> walk = {}; ///< set if the change is only a walk with these
    std::shared_ptr<const EdgeTestBugs> edgeTest = {}; ///< set if the change is only this test
    VisitedBox box = VisitedBox::OfScene;
    bool findsSamples = false; ///< the change begins with a walk or a test, and needs no runs
};

/// The redrawing of a program that has both mistakes; none where they change the same decision. The
/// one that walks the triangle or tests samples comes first, then the other leaves samples out.
std::optional<Redrawing> together(const Redrawing &one, const Redrawing &other);

/// The scene's triangles, each drawn by the scene's method and then changed; whole, or only chosen
/// spans of the method's.
Picture redrawn(const Scene &scene, const Redrawing &redrawing,
                const ChosenSpans *chosen = nullptr);

/// Whether certainly as many pixels as the limit differ from the picture found, as far as that
/// shows in the last triangle of a walk, which nothing paints over; drawn only until they do. The
/// picture may be that of chosen spans.
bool differsAtOnce(const Scene &scene, const Redrawing &redrawing, const Picture &found,
                   std::int64_t limit, const ChosenSpans *chosen = nullptr);

/// What programs with this redrawing draw in arithmetic up to this one. The scene's own is ignored.
PictureRange redrawnRange(const Scene &scene, const Redrawing &redrawing, Arithmetic arithmetic);
/// Whether a scene can be redrawn: it has only triangles, not too many, and needs only colours.
bool canBeRedrawn(const Scene &scene);

/// The scene with only one of its triangles or shapes.
Scene triangleAlone(const Scene &scene, std::size_t triangle);
Scene shapeAlone(const Scene &scene, std::size_t shape);

} // namespace pixelplumb
