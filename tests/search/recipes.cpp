// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/recipe.h"

namespace pixelplumb::search {

namespace {

using enum Figure;
using enum Arithmetic;
using enum Stress;
using enum Window;
using enum Shrink;

constexpr FillRule closed = FillRule::Closed;
constexpr FillRule halfOpen = FillRule::HalfOpenColumn;

constexpr Lattice million = Lattice(1) << 20; ///< px

// A table with two lines per row.
// clang-format off
constexpr Recipe table[] = {
    // Drift: the same rounding at every addition. Far above the x axis an ulp of y is coarse.
    {"drift_float32_251", "drift", "251 columns at y near 250: every addition of the slope rounds the same way",
     Triangle, Float32, closed, WrongPixels, 1, {0, 180}, {251, 70}, 9},
    {"drift_float32_1021", "drift", "1021 columns at y near 1000, where float32 keeps 14 fractional bits",
     Triangle, Float32, closed, WrongPixels, 1, {0, 1000}, {1021, 24}, 9},
    {"drift_float32_2039_16ths", "drift", "2039 columns with vertices on 1/16 px: ties are rare, drift is not",
     Triangle, Float32, halfOpen, WrongPixels, 16, {0, 2000}, {2039, 40}, 120},
    {"drift_float32_8191_up_high", "drift", "8191 columns at y = 30000, where float32 keeps 9 fractional bits",
     Triangle, Float32, closed, WrongPixels, 1, {0, 30000}, {8191, 30}, 9, Whole, ToHalf, 60},
    {"drift_fixed16_509", "drift", "509 columns: the slope in 16.16 is off by up to 1/131072 px a column",
     Triangle, Fixed16, closed, WrongPixels, 1, {0, 0}, {509, 200}, 9},
    {"drift_fixed16_4093", "drift", "4093 columns in 16.16: up to 1/32 px at the end",
     Triangle, Fixed16, halfOpen, WrongPixels, 16, {0, 0}, {4093, 60}, 120, Whole, ToHalf, 120},
    {"drift_fixed16_colour_1021", "drift", "1021 columns of colour accumulated in 16.16",
     Triangle, Fixed16, closed, WrongBytes, 1, {0, 0}, {1021, 60}},
    {"drift_fixed32_8191", "drift", "8191 columns of ties in 32.32",
     Triangle, Fixed32, closed, WrongPixels, 1, {0, 0}, {8191, 30}, 9, Whole, ToHalf, 60},
    {"drift_float64_16381", "drift", "16381 columns at y = 32000 in float64: only ties are lost, but many of them",
     Triangle, Float64, closed, WrongPixels, 1, {0, 32000}, {16381, 16}, 9, Whole, ToHalf, 80},
    {"drift_float32_colour_2039", "drift", "2039 columns of colour: levels near 255 drift by up to 2039 half ulps",
     Triangle, Float32, closed, WrongBytes, 1, {0, 0}, {2039, 40}},

    // Ties: the exact y is an integer, the computed one is a hair off.
    {"tie_float32_16", "tie", "lattice points on the edges of a triangle of 16 px, accumulated in float32",
     Triangle, Float32, closed, WrongPixels, 1, {0, 0}, {16, 16}, 0, Whole, ToAnyFailure},
    {"tie_float64_16", "tie", "lattice points on the edges of a triangle of 16 px: more bits do not mend a tie",
     Triangle, Float64, closed, WrongPixels, 1, {0, 0}, {16, 16}, 0, Whole, ToAnyFailure},
    {"tie_fixed16_16", "tie", "lattice points on the edges of a triangle of 16 px in 16.16",
     Triangle, Fixed16, closed, WrongPixels, 1, {0, 0}, {16, 16}, 0, Whole, ToAnyFailure},
    {"tie_fixed32_16", "tie", "lattice points on the edges of a triangle of 16 px in 32.32",
     Triangle, Fixed32, closed, WrongPixels, 1, {0, 0}, {16, 16}, 0, Whole, ToAnyFailure},
    {"tie_float64_64_most", "tie", "as many lattice points on the edges of a triangle of 64 px as float64 can lose",
     Triangle, Float64, closed, WrongPixels, 1, {0, 0}, {64, 64}},
    {"tie_float64_half_open_64", "tie", "samples on the edges under the half-open rule: owned by one side, taken by the other",
     Triangle, Float64, halfOpen, WrongPixels, 1, {0, 0}, {64, 64}},
    {"tie_float32_half_open_255", "tie", "samples on the edges of a triangle of 255 px under the half-open rule",
     Triangle, Float32, halfOpen, WrongPixels, 1, {0, 0}, {255, 255}},
    {"tie_float64_16ths", "tie", "vertices on 1/16 px whose edges still pass through samples",
     Triangle, Float64, closed, WrongPixels, 16, {0, 0}, {48, 48}},
    {"tie_float64_negative", "tie", "ties left of and below the origin, where y changes its sign",
     Triangle, Float64, closed, WrongPixels, 1, {-40, -40}, {80, 80}},
    {"tie_fixed32_255_most", "tie", "as many lattice points on the edges of a triangle of 255 px as 32.32 can lose",
     Triangle, Fixed32, closed, WrongPixels, 1, {0, 0}, {255, 255}, 0, Whole, ToHalf, 200},

    // Slivers: thinner than the error of the edges.
    {"sliver_float32_1999", "sliver", "a unit thick and 1999 columns long",
     Triangle, Float32, closed, WrongPixels, 1, {0, 1000}, {1999, 40}, 1},
    {"sliver_float32_half_open_997", "sliver", "two units thick and 997 columns long under the half-open rule",
     Triangle, Float32, halfOpen, WrongPixels, 1, {0, 3000}, {997, 300}, 2},
    {"sliver_float64_1021_ties", "sliver", "a unit thick and 1021 columns long: nothing but ties",
     Triangle, Float64, closed, WrongPixels, 1, {0, 0}, {1021, 90}, 1},
    {"sliver_fixed16_2039", "sliver", "a few sixteenths of a pixel thick and 2039 columns long in 16.16",
     Triangle, Fixed16, halfOpen, WrongPixels, 16, {0, 0}, {2039, 90}, 12},
    {"sliver_colour_float32_255", "sliver", "thinner than a pixel with colours across it: the increment is a quotient of two small differences",
     Triangle, Float32, closed, WrongBytes, 16, {0, 0}, {255, 90}, 20},
    {"sliver_steep_float32", "sliver", "a steep sliver: few columns, each of hundreds of rows",
     Triangle, Float32, closed, WrongPixels, 16, {0, 0}, {7, 900}, 24},
    {"sliver_256ths_float32", "sliver", "1/256 px thick, 1500 columns long: covered samples are accidents that arithmetic must not add to",
     Triangle, Float32, closed, WrongPixels, 256, {0, 500}, {1500, 20}, 96},

    // Beyond 2^15 px, where exact products need 128 bits.
    {"wide_exact_just_beyond_32768", "wide", "vertices just beyond 2^15 px: the first for which 64 bits are not proved",
     Triangle, Float32, closed, WrongPixels, 256, {-33000, -33000}, {66000, 66000}, 0, OnEdge},
    {"wide_float32_2_20", "wide", "edges of 2^20 px through a window of 64",
     Triangle, Float32, halfOpen, WrongPixels, 256, {-million / 2, -million / 2}, {million, million}, 0, OnEdge},
    {"wide_float64_2_28", "wide", "an edge of 2^28 px through a sample, in float64",
     Triangle, Float64, closed, WrongPixels, 256, {-128 * million, -128 * million}, {256 * million, 256 * million}, 0, OnSample, ToHalf, 1500},
    {"wide_float32_2_30", "wide", "edges across the whole range of ±2^30 px",
     Triangle, Float32, closed, WrongPixels, 256, {-1024 * million, -1024 * million}, {2048 * million, 2048 * million}, 0, OnEdge},
    {"wide_float64_2_30", "wide", "an edge across the whole range of ±2^30 px through a sample, in float64",
     Triangle, Float64, halfOpen, WrongPixels, 256, {-1024 * million, -1024 * million}, {2047 * million, 2047 * million}, 0, OnSample, ToHalf, 1500},
    {"wide_fixed32_2_20", "wide", "an edge of 2^20 px through a sample in 32.32: a pre-step of 2^19 columns multiplies the slope's error",
     Triangle, Fixed32, closed, WrongPixels, 256, {-million / 2, -million / 2}, {million, million}, 0, OnSample, ToHalf, 1500},
    {"wide_fixed32_wraps", "wide", "differences of 2^31 px do not fit 32.32 and wrap",
     Triangle, Fixed32, closed, WrongPixels, 1, {-1024 * million, -1024 * million}, {2048 * million, 2048 * million}, 0, OnEdge},
    {"wide_sliver_2_24", "wide", "a sliver of 2^24 px through a window of 64",
     Triangle, Float32, closed, WrongPixels, 256, {-8 * million, -8 * million}, {16 * million, 16 * million}, 4000, OnEdge},
    {"wide_colour_float32_2_20", "wide", "colours over 2^20 px through a window of 64",
     Triangle, Float32, closed, WrongBytes, 16, {-million / 2, -million / 2}, {million, million}, 0, OnEdge},

    // Small and far from the origin: the coordinates use up the digits.
    {"far_float32_16384", "far", "24 px at (16384, 16384) on 1/256 px",
     Triangle, Float32, closed, WrongPixels, 256, {16384, 16384}, {24, 24}},
    {"far_float32_2_20", "far", "24 px at (2^20, 2^20): float32 has 3 fractional bits left",
     Triangle, Float32, closed, WrongPixels, 256, {million, million}, {24, 24}},
    {"far_float32_minus_2_20_half_open", "far", "24 px at (−2^20, −2^20) under the half-open rule",
     Triangle, Float32, halfOpen, WrongPixels, 16, {-million, -million}, {24, 24}},
    {"far_float32_2_24_vanishes", "far", "24 px at 2^24 px, where float32 knows only even numbers from there on",
     Triangle, Float32, closed, WrongPixels, 1, {16 * million, 16 * million}, {24, 24}},
    {"far_float64_2_29", "far", "64 px at (2^29, −2^29) in float64: 23 fractional bits are left",
     Triangle, Float64, halfOpen, WrongPixels, 1, {512 * million, -512 * million}, {64, 64}},
    {"far_colour_float32_30011", "far", "20 px at (30011, 30011): the colours of a small triangle far away",
     Triangle, Float32, closed, WrongBytes, 256, {30011, 30011}, {20, 20}},

    // Tips: y_T − y_B goes to zero where the colours of both edges meet.
    {"tip_left_float32", "tip", "a left tip between two columns: ΔR is a quotient of two small differences",
     Triangle, Float32, closed, WrongBytes, 256, {0, 0}, {60, 12}, 60, Whole, ToAnyFailure, 4000},
    {"tip_right_float64", "tip", "columns at the right tip, where the accumulated edges cross before they should",
     Triangle, Float64, closed, WrongPixels, 1, {0, 0}, {31, 9}, 1, Whole, ToAnyFailure},
    {"tip_fixed16_many", "tip", "a sharp tip in 16.16: y_T − y_B has few bits left",
     Triangle, Fixed16, closed, WrongBytes, 256, {0, 0}, {100, 40}, 200},
    {"tip_fixed32_half_open", "tip", "a sharp tip in 32.32 under the half-open rule",
     Triangle, Fixed32, halfOpen, WrongBytes, 16, {0, 0}, {60, 12}, 3, Whole, ToHalf, 4000},

    // Levels that leave 0 … 255.
    {"clamp_float32_2_20", "clamp", "12 columns at 2^20 px: the pre-step is off by 1/16 px times 20 levels a column",
     Triangle, Float32, closed, ClampedPixels, 256, {million, million}, {12, 30}, 0, Whole, ToHalf, 1500},
    {"clamp_float32_2_22_low", "clamp", "columns at x = 2^22 px near the x axis: levels of the edges overshoot, their y does not",
     Triangle, Float32, closed, ClampedPixels, 256, {4 * million, 100}, {14, 60}, 0, Whole, ToHalf, 1500},
    {"clamp_float32_half_open_minus_2_21", "clamp", "overshoot under the half-open rule at −2^21 px",
     Triangle, Float32, halfOpen, ClampedPixels, 256, {-2 * million, 7}, {9, 40}, 0, Whole, ToHalf, 1500},
    {"clamp_fixed16_997", "clamp", "997 columns, thinner than 1/128 px: the levels a row do not fit 16.16",
     Triangle, Fixed16, closed, ClampedPixels, 1, {0, 0}, {997, 200}, 1, Whole, ToHalf, 1500},
    {"clamp_float32_smallest", "clamp", "the simplest triangle at 2^19 px whose levels overshoot",
     Triangle, Float32, closed, ClampedPixels, 256, {million / 2, 0}, {4, 16}, 0, Whole, ToAnyFailure, 1500},
    {"sliver_colour_fixed32", "sliver", "1/256 px thick: a tie of the edges in 32.32 is tens of thousands of levels a pixel away",
     Triangle, Fixed32, closed, WrongBytes, 16, {0, 0}, {400, 30}, 4, Whole, ToHalf, 1500},

    // Wraps of 16.16: 15 bits before the point and a sign.
    {"wrap_fixed16_difference", "wrap", "vertices 40000 px apart fit 16.16, their difference does not",
     Triangle, Fixed16, closed, WrongPixels, 1, {-32767, -32767}, {65534, 65534}, 0, OnEdge},
    {"wrap_fixed16_slope", "wrap", "a slope of more than 2^15 px a column: a steep edge between two columns",
     Triangle, Fixed16, closed, WrongPixels, 256, {0, 0}, {2, 12000}, 0, Whole, ToHalf, 1000},
    {"wrap_fixed16_pre_step", "wrap", "a steep slope times the pre-step to the window",
     Triangle, Fixed16, halfOpen, WrongPixels, 16, {-16000, -16000}, {32000, 32000}, 0, OnEdge},
    {"wrap_fixed16_colour_rate", "wrap", "levels a row beyond 2^15 on a sliver 1/256 px thick",
     Triangle, Fixed16, closed, ClampedPixels, 256, {0, 0}, {200, 20}, 60, Whole, ToHalf, 2000},

    // Half levels: the exact colour is n + 1/2.
    {"half_level_float64", "colour", "exact levels of n + 1/2 that float64 computes a hair too small",
     Triangle, Float64, closed, WrongBytes, 1, {0, 0}, {64, 64}},
    {"half_level_float64_small", "colour", "the smallest triangle that has a half level which float64 misses",
     Triangle, Float64, closed, WrongBytes, 1, {0, 0}, {12, 12}, 0, Whole, ToAnyFailure},
    {"half_level_fixed32", "colour", "exact levels of n + 1/2 in 32.32",
     Triangle, Fixed32, halfOpen, WrongBytes, 1, {0, 0}, {64, 64}},
    {"near_vertical_colour_float32", "colour", "two columns wide and 700 rows high: the increment along the column drifts",
     Triangle, Float32, closed, WrongBytes, 16, {0, 0}, {3, 700}},

    // Meshes: each interior sample once.
    {"fan_slivers_float32_16384", "shared-edge", "a fan of slivers at (16384, 16384) on 1/256 px",
     Fan, Float32, halfOpen, GapsAndOverdraw, 256, {16384, 16384}, {90, 24}},
    {"fan_float32_2_20", "shared-edge", "a fan at (2^20, 2^20): both sides of an edge round alike, its ends do not",
     Fan, Float32, halfOpen, GapsAndOverdraw, 256, {million, million}, {60, 40}},
    {"grid_float32_16384", "shared-edge", "a grid of 4 px cells at (16384, 16384) on 1/256 px",
     Grid, Float32, halfOpen, GapsAndOverdraw, 256, {16384, 16384}, {12, 12}, 0, Whole, ToHalf, 1500},
    {"grid_float32_2_20", "shared-edge", "a grid of 8 px cells at (−2^20, 2^20)",
     Grid, Float32, halfOpen, GapsAndOverdraw, 256, {-million, million}, {24, 24}},
    {"grid_float32_closed", "shared-edge", "whole-pixel vertices under the closed rule: shared samples are drawn twice, or lost twice",
     Grid, Float32, closed, GapsAndOverdraw, 1, {0, 0}, {48, 48}},
    {"strip_fixed16_1500", "shared-edge", "a strip 1500 px long in 16.16",
     Strip, Fixed16, halfOpen, GapsAndOverdraw, 256, {0, 0}, {1500, 60}, 0, Whole, ToHalf, 200},
    {"t_junction_float32_400", "t-junction", "the middle vertex lies exactly on the long edge, which drifts past it",
     TJunction, Float32, halfOpen, GapsAndOverdraw, 1, {0, 0}, {200, 200}},
    {"t_junction_float32_far", "t-junction", "a T-junction at (16384, 16384)",
     TJunction, Float32, halfOpen, GapsAndOverdraw, 16, {16384, 16384}, {80, 80}},
    {"t_junction_float64_400", "t-junction", "a T-junction on whole pixels in float64: ties on the long edge fall to other sides",
     TJunction, Float64, halfOpen, GapsAndOverdraw, 1, {0, 0}, {200, 200}},
    {"t_junction_fixed32_2_20", "t-junction", "a T-junction on whole pixels at (2^20, −2^20) in 32.32",
     TJunction, Fixed32, halfOpen, GapsAndOverdraw, 1, {million, -million}, {100, 100}},

    // Time: what appears and disappears while a sliver slides by (2, 1) units a frame.
    {"flicker_float32_997", "temporal", "a sliver 997 px long slides by (1/8, 1/16) px a frame",
     Slide, Float32, closed, Flicker, 16, {0, 1000}, {997, 24}, 16, Whole, ToHalf, 60},
    {"flicker_float32_half_open_601", "temporal", "a sliver 601 px long slides by (1/128, 1/256) px a frame",
     Slide, Float32, halfOpen, Flicker, 256, {0, 3000}, {601, 24}, 256, Whole, ToHalf, 60},
    {"flicker_float64_ties_251", "temporal", "a sliver on whole pixels slides by (2, 1) px a frame: ties come and go in float64",
     Slide, Float64, closed, Flicker, 1, {0, 0}, {251, 40}, 3, Whole, ToHalf, 60},
    {"flicker_fixed16_601", "temporal", "a sliver 601 px long slides by (1/8, 1/16) px a frame in 16.16",
     Slide, Fixed16, closed, Flicker, 16, {0, 0}, {601, 24}, 16, Whole, ToHalf, 60},

    // Place: a move by whole pixels moves the picture and nothing else.
    {"moved_float32_200", "translation", "a triangle of 200 px at four whole-pixel offsets in float32",
     Moved, Float32, closed, Pictures, 16, {0, 0}, {200, 200}, 0, Whole, ToHalf, 100},
    {"moved_float64_ties_64", "translation", "ties of a triangle on whole pixels fall otherwise elsewhere in float64",
     Moved, Float64, closed, Pictures, 1, {0, 0}, {64, 64}},
    {"moved_fixed16_200", "translation", "a triangle of 200 px at four whole-pixel offsets in 16.16: equally wrong everywhere",
     Moved, Fixed16, halfOpen, WrongPixels, 16, {0, 0}, {200, 200}, 0, Whole, ToHalf, 100},
    {"moved_float32_sliver", "translation", "a sliver of 300 px at four whole-pixel offsets",
     Moved, Float32, halfOpen, Pictures, 16, {0, 0}, {300, 90}, 12, Whole, ToHalf, 100},
};
// clang-format on

} // namespace

std::span<const Recipe> recipes() { return table; }

} // namespace pixelplumb::search
