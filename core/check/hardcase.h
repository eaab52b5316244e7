// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/shape.h"
#include "core/number/quantity.h"
#include "core/scan/scansettings.h"
#include "core/scene/result.h"

#include <QByteArray>
#include <QStringList>

#include <map>
#include <optional>
#include <vector>

namespace pixelplumb {

/// What a hard case asks for.
enum class HardCaseKind {
    Triangle, ///< which pixels, which colours
    Mesh, ///< how often each pixel is covered by triangles that share edges
    Sequence, ///< how many pixels come and go while a triangle slides
    Translation, ///< whether a move by whole pixels moves the picture and nothing else
    Invalid, ///< that its coordinates are refused
    Line, ///< a line instead of a triangle
    Circle, ///< a circle, outlined or filled
    Polygon, ///< polygons of one or more contours: which pixels, and how often
    Attributes, ///< a triangle whose vertices carry more than colour: the values at its points
    Effects, ///< triangles with depth, perspective, texture, alpha, antialiasing: which colours
};

/// What is known of a case under one fill rule; none where the case does not say.
struct ExpectedFacts {
    std::optional<std::int64_t> pixelCount; ///< of a triangle or of each translated picture
    QByteArray spanHash; ///< 16 hexadecimal digits, see spanHashOf
    std::optional<std::array<std::int64_t, 3>> channelSums; ///< of the bytes of all pixels
    std::map<int, std::int64_t> histogram; ///< mesh, polygons: pixels by how often they are covered
    std::vector<std::int64_t> frameCounts; ///< sequence: pixels of each frame
    std::optional<std::int64_t> toggles; ///< sequence: pixels that change between frames
    std::optional<std::int64_t> distinctPictures; ///< translation
    /// Line, circle, polygon: the first 16 hexadecimal digits of the SHA-256 of "x y\n" for each
    /// pixel, along x (by columns); of a line along y where it is longer that way.
    QByteArray pixelHash;
    QByteArray colourHash; ///< effects: the same of "x y r g b\n", by columns
    std::vector<std::array<std::int64_t, 2>> pixels; ///< line: x and y of each, in this order
};

/// What is known of one sample.
struct ExpectedPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::map<FillRule, bool> covered;
    std::array<QString, 3> exactColour; ///< "85/42", levels; inside and outside
    std::array<std::int64_t, 3> roundedColour = {}; ///< of exactColour, not clamped
    std::map<QString, Quantity> values; ///< attributes: exact, by the title of a sample's cell
};

/// A case of a file of hard cases. Pixels are sampled at integers; the canvas begins at
/// `canvas.firstColumn` and `firstRow`. Facts under the top-left rule take y as pointing down, all
/// others as pointing up.
struct HardCase {
    QString id;
    HardCaseKind kind = HardCaseKind::Triangle;
    QString stresses; ///< one sentence: what is hard about it
    FrameSpec canvas;
    std::vector<Triangle> triangles; ///< one, those of the mesh, or one a frame of the sequence
    std::vector<Shape> shapes; ///< the line, the circle, the polygons
    std::vector<TriangleAttributes> attributes; ///< of the triangles, if their vertices carry any
    Appearance appearance; ///< effects
    std::vector<std::array<std::int64_t, 2>> offsets; ///< translation, px
    std::map<FillRule, ExpectedFacts> facts;
    std::vector<ExpectedPoint> points;
    /// The coordinates that had to be snapped, each with its displacement. The facts then hold for
    /// other vertices than the ones that are drawn, and the snapped triangle is compared with the
    /// truth.
    QStringList displacements;
    /// Of an invalid case: why its coordinates were refused; empty when they were accepted.
    QString refusal;
};

/// Reads a file of hard cases (JSON, format version 1).
Result<std::vector<HardCase>> readHardCases(const QByteArray &text);
/// Those that are part of the program, so that every machine has the same ones; none in a program
/// without them.
Result<std::vector<HardCase>> builtInHardCases();

} // namespace pixelplumb
