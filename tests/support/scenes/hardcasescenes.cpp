// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/hardcasescenes.h"

#include "core/compare/casegallery.h"
#include "core/runs/tracedscene.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/sourcetree.h"

#include <QTest>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int32_t detailWidth = 16;
constexpr std::int32_t detailHeight = 12;
constexpr std::size_t mostPrimitives = 12;

/// Bounds in lattice units.
struct Box {
    LatticePoint least;
    LatticePoint greatest;
};

Box boxAround(std::span<const Vertex> vertices)
{
    Box box{vertices.front().position, vertices.front().position};
    for (const Vertex &vertex : vertices) {
        box.least.x = std::min(box.least.x, vertex.position.x);
        box.least.y = std::min(box.least.y, vertex.position.y);
        box.greatest.x = std::max(box.greatest.x, vertex.position.x);
        box.greatest.y = std::max(box.greatest.y, vertex.position.y);
    }
    return box;
}

bool reaches(const Triangle &triangle, const FrameSpec &frame)
{
    const Box box = boxAround(triangle.vertices);
    return box.greatest.x >= frame.firstColumn * unitsPerPixel
        && box.greatest.y >= frame.firstRow * unitsPerPixel
        && box.least.x <= (frame.firstColumn + frame.width) * unitsPerPixel
        && box.least.y <= (frame.firstRow + frame.height) * unitsPerPixel;
}

/// A picture of the scene, transparent where nothing is written.
template <class Draw>
FrameBuffer pictureBy(const Scene &scene, const Draw &draw)
{
    FrameBuffer frame(scene.frame);
    const FrameView view = frame.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y)
        std::fill_n(view.at(view.firstColumn, y), view.width, QRgb(0));
    draw(scene, frame);
    return frame;
}

/// The first pixel, row by row, at which two pictures differ.
std::optional<std::array<std::int64_t, 2>> firstDifference(const FrameView &a, const FrameView &b)
{
    for (std::int64_t y = a.firstRow; y < a.endRow(); ++y) {
        const QRgb *row = a.at(a.firstColumn, y);
        const auto [mine, other] = std::mismatch(row, row + a.width, b.at(b.firstColumn, y));
        if (mine != row + a.width)
            return std::array{a.firstColumn + std::int64_t(mine - row), y};
    }
    return std::nullopt;
}

/// The first pixel, row by row, that is not transparent.
std::optional<std::array<std::int64_t, 2>> firstWritten(const FrameView &picture)
{
    for (std::int64_t y = picture.firstRow; y < picture.endRow(); ++y) {
        const QRgb *row = picture.at(picture.firstColumn, y);
        const QRgb *found
            = std::find_if(row, row + picture.width, [](QRgb pixel) { return pixel != 0; });
        if (found != row + picture.width)
            return std::array{picture.firstColumn + std::int64_t(found - row), y};
    }
    return std::nullopt;
}

/// The first pixel that one of the method's arithmetics gets wrong; if there is none, the first
/// covered pixel, or else the frame's first.
std::array<std::int64_t, 2> hardPlaceOf(const Scene &scene)
{
    const FrameBuffer truth = pictureBy(scene, drawTruth);
    Scene rounded = scene;
    for (const Arithmetic arithmetic :
         methodNamed(QString::fromStdString(scene.method))->arithmetics) {
        rounded.settings.arithmetic = arithmetic;
        const FrameBuffer drawn = pictureBy(rounded, drawScene);
        if (const auto place = firstDifference(drawn.view(), truth.view()))
            return *place;
    }
    return firstWritten(truth.view())
        .value_or(std::array<std::int64_t, 2>{scene.frame.firstColumn, scene.frame.firstRow});
}

Scene detailOf(const Scene &scene)
{
    const auto [x, y] = hardPlaceOf(scene);
    const FrameSpec &whole = scene.frame;
    const auto placed
        = [](std::int64_t middle, std::int32_t size, std::int32_t first, std::int32_t wholeSize) {
              return std::int32_t(
                  std::clamp<std::int64_t>(middle - size / 2, first, first + wholeSize - size));
          };
    Scene detail = scene;
    detail.frame.width = std::min(whole.width, detailWidth);
    detail.frame.height = std::min(whole.height, detailHeight);
    detail.frame.firstColumn = placed(x, detail.frame.width, whole.firstColumn, whole.width);
    detail.frame.firstRow = placed(y, detail.frame.height, whole.firstRow, whole.height);
    if (detail.triangles.size() > mostPrimitives) {
        std::erase_if(detail.triangles,
                      [&](const Triangle &triangle) { return !reaches(triangle, detail.frame); });
        detail.triangles.resize(std::min(detail.triangles.size(), mostPrimitives));
    }
    return detail;
}

} // namespace

std::vector<NamedScene> hardCaseScenes()
{
    std::vector<NamedScene> scenes;
    const Result<QByteArray> text = readFile(testData("hard_cases.json"));
    const Result<std::vector<GalleryCase>> gallery = text ? readGallery(*text) : text.error();
    if (!gallery) {
        QTest::qFail(qPrintable(gallery.error().message()), __FILE__, __LINE__);
        return {};
    }
    for (const GalleryCase &each : *gallery)
        scenes.push_back({each.hardCase.id, sceneOf(each.hardCase, methods().front(), {})});
    return scenes;
}

std::vector<NamedScene> hardCaseDetails()
{
    std::vector<NamedScene> scenes = hardCaseScenes();
    for (NamedScene &each : scenes)
        each.second = detailOf(each.second);
    return scenes;
}

} // namespace pixelplumb
