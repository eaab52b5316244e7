// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/shape.h"
#include "core/number/quantity.h"
#include "core/scan/scansettings.h"
#include "core/scene/text/result.h"

#include <QByteArray>
#include <QStringList>

#include <map>
#include <optional>
#include <vector>

namespace pixelplumb {

/// What a hard case tests.
enum class HardCaseKind {
    Triangle, ///< which pixels, which colours
    Mesh, ///< how often each pixel is covered by triangles that share edges
    Sequence, ///< how many pixels come and go while a triangle slides
    Translation, ///< whether a move by whole pixels moves the picture and changes nothing else
    Invalid, ///< that invalid coordinates are refused
    Line, ///< a line instead of a triangle
    Circle, ///< a circle, outlined or filled
    Polygon, ///< polygons of one or more contours: which pixels, and how often
    Attributes, ///< a triangle whose vertices carry more than colour: the values at its points
    Effects, ///< triangles with depth, perspective, texture, alpha, antialiasing: which colours
};

/// The expected results of a case under one fill rule; none where the case gives none.
struct ExpectedFacts {
    std::optional<std::int64_t> pixelCount; ///< of a triangle, or of each translated picture
    QByteArray spanHash; ///< 16 hexadecimal digits, see CasePicture::spanHash
    std::optional<std::array<std::int64_t, 3>> channelSums; ///< sums of the bytes of all pixels
    std::map<int, std::int64_t> histogram; ///< mesh, polygons: pixels by how often they are covered
    std::vector<std::int64_t> frameCounts; ///< sequence: pixels of each frame
    std::optional<std::int64_t> toggles; ///< sequence: pixels that change between frames
    std::optional<std::int64_t> distinctPictures; ///< translation
    /// Line, circle, polygon: the first 16 hexadecimal digits of the SHA-256 of "x y
    /// " for each pixel, ordered along x (by columns), or along y for a line that is longer that
    /// way.
    QByteArray pixelHash;
    QByteArray colourHash; ///< effects: like pixelHash, of "x y r g b\n", by columns
    std::vector<std::array<std::int64_t, 2>> pixels; ///< line: x and y of each pixel, in this order
};

/// The expected results at one sample.
struct ExpectedPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::map<FillRule, bool> covered;
    std::array<QString, 3> exactColour; ///< "85/42", levels; given inside and outside the triangle
    std::array<std::int64_t, 3> roundedColour = {}; ///< exactColour rounded, not clamped
    std::map<QString, Quantity> values; ///< attributes: exact, by the title of the sample's cell
};

/// A case of a file of hard cases. Pixels are sampled at integers; the canvas begins at
/// `canvas.firstColumn` and `firstRow`. For facts under the top-left rule y points down, for all
/// others up.
struct HardCase {
    QString id;
    HardCaseKind kind = HardCaseKind::Triangle;
    QString stresses; ///< one sentence: what is hard about it
    FrameSpec canvas;
    std::vector<Triangle> triangles; ///< one, those of the mesh, or one per frame of the sequence
    std::vector<Shape> shapes; ///< the line, the circle, the polygons
    std::vector<TriangleAttributes> attributes; ///< of the triangles, if their vertices have any
    Appearance appearance; ///< effects
    std::vector<std::array<std::int64_t, 2>> offsets; ///< translation, px
    std::map<FillRule, ExpectedFacts> facts;
    std::vector<ExpectedPoint> points;
    /// The coordinates that had to be snapped, each with its displacement. The facts then hold for
    /// vertices other than the drawn ones, so the snapped triangle is compared with the truth.
    QStringList displacements;
    /// For an invalid case: why its coordinates were refused; empty if they were accepted.
    QString refusal;
};

/// Reads a file of hard cases (JSON, format version 1).
Result<std::vector<HardCase>> readHardCases(const QByteArray &text);
/// The cases compiled into the program, the same on every machine; empty in a program without them.
Result<std::vector<HardCase>> builtInHardCases();

} // namespace pixelplumb
