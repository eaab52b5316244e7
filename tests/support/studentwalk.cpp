// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/studentwalk.h"

#include "tests/support/studentloops.h"

namespace pixelplumb {

namespace {

using namespace studentloops;

template <class Number>
Picture pictureIn(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes)
{
    Picture picture{scene.frame.width, scene.frame.height, {}, {}};
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    picture.colours.resize(pixels, scene.frame.background);
    picture.covered.resize(pixels, 0);
    const bool goesByRows = lines == WalkLines::Rows;
    const int onward = goesByRows && !mistakes.contains(WalkMistake::FromBelow) ? -1 : 1;
    const auto paint = [&](int span, int sample, Colour colour) {
        const int x = goesByRows ? sample : span;
        const int y = goesByRows ? onward * span : sample;
        if (x < 0 || x >= picture.width || y < 0 || y >= picture.height)
            return;
        const std::size_t place = picture.placeOf(x, picture.height - 1 - y);
        picture.colours[place] = colour;
        picture.covered[place] = 1;
    };
    for (const Triangle &triangle : scene.triangles) {
        std::array<Corner<Number>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex &vertex = triangle.vertices[i];
            const Number x = Number(vertex.position.x) / unitsPerPixel;
            const Number y = Number(vertex.position.y) / unitsPerPixel;
            corners[i].x = onward * (goesByRows ? y : x);
            corners[i].y = goesByRows ? x : y;
            for (std::size_t channel = 0; channel < 3; ++channel)
                corners[i].colour[channel] = int(vertex.colour.channels[channel]);
        }
        ColumnLoops<Number>(mistakes, onward).draw(corners, paint);
    }
    return picture;
}

} // namespace

Picture studentPicture(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes)
{
    return pictureIn<Fraction>(scene, lines, mistakes);
}

Picture studentPictureInDouble(const Scene &scene, WalkLines lines,
                               const std::set<WalkMistake> &mistakes)
{
    return pictureIn<double>(scene, lines, mistakes);
}

} // namespace pixelplumb
