// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/motionstudy.h"

#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

namespace {

constexpr Colour paint = {{255, 255, 255}};
constexpr std::size_t mostNamed = 1'000'000;

/// The scene's geometry in one colour on black, without effects: a pixel is painted if it is not
/// black.
Scene silhouetteOf(Scene scene)
{
    scene.frame.background = Colour{};
    scene.appearance = {};
    scene.attributes.clear();
    for (Triangle &triangle : scene.triangles) {
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = paint;
    }
    for (Shape &shape : scene.shapes) {
        for (Vertex &vertex : shape.vertices)
            vertex.colour = paint;
    }
    return scene;
}

/// Counts the painted pixels, and those that differ from the picture before.
template <class CountToggle>
std::pair<std::int64_t, std::int64_t> countIn(FrameView now, FrameView before,
                                              CountToggle countToggle)
{
    std::int64_t painted = 0;
    std::int64_t toggled = 0;
    const QRgb black = qRgb(0, 0, 0);
    for (std::int64_t y = now.firstRow; y < now.endRow(); ++y) {
        for (std::int64_t x = now.firstColumn; x < now.endColumn(); ++x) {
            const bool isPainted = *now.at(x, y) != black;
            painted += int(isPainted);
            if (isPainted == (*before.at(x, y) != black))
                continue;
            ++toggled;
            countToggle(x, y);
        }
    }
    return {painted, toggled};
}

std::int64_t sumOf(const std::vector<MotionFrame> &frames, std::int64_t MotionFrame::*toggled)
{
    std::int64_t sum = 0;
    for (const MotionFrame &frame : frames)
        sum += frame.*toggled;
    return sum;
}

} // namespace

std::int64_t MotionStudy::toggled() const { return sumOf(frames, &MotionFrame::toggled); }

std::int64_t MotionStudy::truthToggled() const { return sumOf(frames, &MotionFrame::truthToggled); }

std::vector<QPoint> toggledPixels(const Scene &scene, int frame)
{
    std::vector<QPoint> pixels;
    if (frame < 1)
        return pixels;
    const Scene silhouette = silhouetteOf(scene);
    const FrameBuffer now(silhouette.frame);
    const FrameBuffer before(silhouette.frame);
    drawScene(sceneAtFrame(silhouette, frame), now);
    drawScene(sceneAtFrame(silhouette, frame - 1), before);
    countIn(now.view(), before.view(), [&](std::int64_t x, std::int64_t y) {
        if (pixels.size() < mostNamed)
            pixels.emplace_back(int(x - scene.frame.firstColumn), pictureLine(scene.frame, y));
    });
    return pixels;
}

std::optional<MotionStudy> studyMotion(const Scene &scene, const ProgressListener &listener)
{
    const int count = scene.motion ? scene.motion->frames : 1;
    const Scene silhouette = silhouetteOf(scene);
    MotionStudy study{{}, FrameMap<PixelToggles>(scene.frame)};
    std::optional<FrameBuffer> drawnBefore;
    std::optional<FrameBuffer> truthBefore;
    for (int number = 0; number < count; ++number) {
        if (!goesOn(listener, {JobPhase::Drawing, number, count}))
            return std::nullopt;
        const SceneRun moved(sceneAtFrame(silhouette, number));
        FrameBuffer drawn(silhouette.frame);
        FrameBuffer truth(silhouette.frame);
        moved.draw(drawn.view());
        moved.drawTruth(truth.view());
        MotionFrame frame;
        const bool isFirst = !drawnBefore;
        std::tie(frame.drawn, frame.toggled)
            = countIn(drawn.view(), (isFirst ? drawn : *drawnBefore).view(),
                      [&](std::int64_t x, std::int64_t y) { ++study.toggles.at(x, y).drawn; });
        std::tie(frame.truth, frame.truthToggled)
            = countIn(truth.view(), (isFirst ? truth : *truthBefore).view(),
                      [&](std::int64_t x, std::int64_t y) { ++study.toggles.at(x, y).truth; });
        study.frames.push_back(frame);
        drawnBefore.emplace(std::move(drawn));
        truthBefore.emplace(std::move(truth));
    }
    return study;
}

} // namespace pixelplumb
