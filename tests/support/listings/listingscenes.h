// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "tests/support/listings/listingrun.h"

#include <random>

/// Random primitives whose listings are run, and what their kernels draw.
namespace pixelplumb {

/// A triangle of one of twelve kinds, by the number: on whole pixels, where there are ties; between
/// them; smaller than a pixel; upright, level or thin; without area; beyond each side of the frame.
/// Frames cut some of them, begin at negative coordinates, or have y pointing down.
Scene oddTriangleScene(int number, std::mt19937 &random);

BigRational inPixels(Lattice units);

/// The coordinates and levels of a triangle as given: x₀, y₀, R₀ …
ListingNames vertexNames(const Triangle &triangle, const FrameSpec &frame);
/// The numbers of the first primitive's set-up, by their titles.
ListingNames setUpNames(const TracedScene &traced);

SampleBox frameBox(const FrameSpec &frame);
/// The pixels that the kernel writes; a single triangle writes each once.
ListingRun::Pixels pixelsOf(const TracedScene &traced);

/// The arithmetics of a method in which its listing is run.
std::vector<Arithmetic> listedArithmetics(const Method &method);

/// How pixels that listings drew differ from the kernel's; empty if they do not.
QString differenceOf(const ListingRun::Pixels &pixels, const TracedScene &traced);

/// Runs a listing of the scene's first primitive in the scene's arithmetic; says how its picture
/// differs from the kernel's, or why it cannot be run. Empty if the two are the same.
QString departureOf(ListingRun &run, const TracedScene &traced);

} // namespace pixelplumb
