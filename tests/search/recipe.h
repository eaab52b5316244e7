// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/search/measure.h"
#include "tests/search/randomnumbers.h"

#include <span>

namespace pixelplumb::search {

/// The figure built from the points that a search moves.
enum class Figure {
    Triangle, ///< three points
    Fan, ///< an apex on the left, its rim to the right
    Strip, ///< a zigzag of two rows
    Grid, ///< quads, each cut along a diagonal
    TJunction, ///< a long edge against two halves whose common vertex lies exactly on it
    Slide, ///< a triangle that moves by one step per frame
    Moved, ///< a triangle at several whole-pixel offsets
};

inline constexpr int gridSide = 4; ///< points along a side of Figure::Grid

/// What the search tries to maximize.
enum class Stress { WrongPixels, WrongBytes, ClampedPixels, GapsAndOverdraw, Flicker, Pictures };

/// Which part of the figure the canvas shows.
enum class Window {
    Whole, ///< its bounding box
    OnEdge, ///< a square on the edge between the first two points
    OnSample, ///< a square around a sample that this edge passes through exactly
};

/// How far a find is simplified in the end.
enum class Shrink {
    ToAnyFailure, ///< the simplest that still fails
    ToHalf, ///< the simplest that is still half as bad
};

/// A family of figures and the failure to look for among them.
struct Recipe {
    const char *id;
    const char *family;
    const char *reason; ///< one sentence: what is hard about it
    Figure figure = Figure::Triangle;
    Arithmetic arithmetic = Arithmetic::Float32;
    FillRule rule = FillRule::Closed;
    Stress stress = Stress::WrongPixels;
    Lattice scale = 1; ///< coordinates are multiples of 1/scale px
    LatticePoint corner = {}; ///< of the box that holds the points, px
    LatticePoint size = {}; ///< of that box, px
    Lattice thickness = 0; ///< in 1/scale px: how near the third point is to the first two; 0:
                           ///< anywhere
    Window window = Window::Whole;
    Shrink shrink = Shrink::ToHalf;
    int rounds = 400; ///< random figures, and equally many moves uphill
};

std::span<const Recipe> recipes();

/// What the search changes: the points in 1/scale px, the colours, and the position of the window.
struct Genes {
    std::vector<LatticePoint> points;
    std::array<Colour, 3> colours;
    std::int64_t sixteenths = 8; ///< OnEdge: the window's place along the edge
    LatticePoint sample; ///< OnSample: px
};

Genes randomGenes(const Recipe &recipe, RandomNumbers &random);
/// The genes with a few points, colours or the window changed.
Genes mutated(const Recipe &recipe, Genes genes, RandomNumbers &random);

/// The case without its facts; none if the figure makes no sense.
std::optional<HardCase> expressed(const Recipe &recipe, const Genes &genes);

/// How badly the recipe's arithmetic fails at a case.
struct Score {
    std::int64_t sought = 0; ///< the error that the recipe looks for
    std::int64_t other = 0; ///< any wrong pixels: guides the search while none of the sought error
                            ///< is found

    friend auto operator<=>(const Score &, const Score &) = default;
};

Score scoreOf(const Recipe &recipe, const HardCase &hardCase);

} // namespace pixelplumb::search
