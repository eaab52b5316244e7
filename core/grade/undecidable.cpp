// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/undecidable.h"

#include "core/frame/framebuffer.h"
#include "core/grade/picturediff.h"
#include "core/grade/programline.h"
#include "core/grade/triangleleeway.h"
#include "core/runs/sceneplan.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

/// What is known of a pixel while triangles are removed one by one, the last drawn first.
enum class Leeway : std::uint8_t {
    Sought, ///< no removed triangle reaches it
    Open, ///< the removed triangles may have left it out
    Refused,
    Given,
};

bool isSame(const Picture &one, const Picture &other, std::size_t place)
{
    return one.hasColours && other.hasColours ? one.colours[place] == other.colours[place]
                                              : one.covered[place] == other.covered[place];
}

class LayeredLeeway {
public:
    LayeredLeeway(const Scene &scene, const Picture &drawn, const Picture &found)
        : m_scene(scene)
        , m_found(found)
        , m_pixels(found.size(), Leeway::Sought)
    {
        for (std::size_t place = 0; place < found.size(); ++place) {
            if (isSame(drawn, found, place))
                m_pixels[place] = Leeway::Refused; // needs no leeway
        }
    }

    void takeOff(const TriangleLeeway &triangle)
    {
        const SampleBox box = triangle.reachIn(m_scene.frame);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place = m_found.placeOf(int(x - m_scene.frame.firstColumn),
                                                          pictureLine(m_scene.frame, y));
                if (m_pixels[place] == Leeway::Sought || m_pixels[place] == Leeway::Open)
                    m_pixels[place] = leewayBelow(triangle, place, x, y);
            }
        }
    }
    /// A pixel that is still open counts if it shows the background.
    std::vector<std::uint8_t> pixels() const
    {
        std::vector<std::uint8_t> given(m_pixels.size(), 0);
        for (std::size_t place = 0; place < given.size(); ++place) {
            const bool isBare = m_pixels[place] == Leeway::Open && isBackground(place);
            given[place] = isBare || m_pixels[place] == Leeway::Given ? 1 : 0;
        }
        return given;
    }

private:
    bool isBackground(std::size_t place) const
    {
        return m_found.covered[place] == 0
            || (m_found.hasColours && m_found.colours[place] == m_scene.frame.background);
    }
    Leeway leewayBelow(const TriangleLeeway &triangle, std::size_t place, std::int64_t x,
                       std::int64_t y) const
    {
        const Containment where = triangle.containmentOf(x, y);
        if (where == Containment::Outside)
            return m_pixels[place];
        // A raster has no colours: inside, nothing of it is open.
        const bool isInside = where == Containment::Inside;
        const bool isOf = m_found.hasColours
            ? triangle.mayHave(m_found.colours[place], x, y)
            : m_found.covered[place] != 0 && (!isInside || m_pixels[place] == Leeway::Open);
        if (isOf)
            return Leeway::Given;
        return isInside ? Leeway::Refused : Leeway::Open;
    }

    const Scene &m_scene;
    const Picture &m_found;
    std::vector<Leeway> m_pixels;
};

/// The scene under each rule that its method knows, displaced in every direction where a rule can
/// be, and without each of its triangles.
std::vector<Picture> picturesOfAllRules(Scene scene)
{
    std::vector<Picture> pictures;
    const auto add = [&] {
        if (objectionTo(scene).isEmpty())
            pictures.push_back(pictureOf(scene));
    };
    for (const FillRule rule : allFillRules) {
        scene.settings.fillRule = rule;
        if (rule != FillRule::OffScreenPoint) {
            add();
            continue;
        }
        const FrameSpec &frame = scene.frame;
        // Off the diagonals, on which edges lie more often.
        for (const int x : {frame.firstColumn - 7, frame.firstColumn + frame.width + 7}) {
            for (const int y : {frame.firstRow - 5, frame.firstRow + frame.height + 5}) {
                scene.frame.offScreenPoint = latticePixel(x, y);
                add();
            }
        }
    }
    // Simulates rules that this method does not know, in which a triangle leaves out its edges
    // while its neighbours do not; only for few triangles.
    constexpr std::size_t fewTriangles = 16;
    scene.settings.fillRule = FillRule::Closed;
    const std::size_t left = scene.triangles.size() <= fewTriangles ? scene.triangles.size() : 0;
    for (std::size_t i = 0; i < left; ++i) {
        const Triangle kept = scene.triangles[i];
        for (Vertex &vertex : scene.triangles[i].vertices)
            vertex.position = latticePixel(scene.frame.firstColumn - 2, scene.frame.firstRow - 2);
        add();
        scene.triangles[i] = kept;
    }
    return pictures;
}

std::vector<std::uint8_t> ofAnotherRule(const Scene &scene, const Picture &drawn,
                                        const Picture &found)
{
    std::vector<std::uint8_t> ties = tiesOf(scene);
    for (std::size_t place = 0; place < ties.size(); ++place)
        ties[place] = ties[place] != 0 && !isSame(drawn, found, place) ? 1 : 0;
    if (std::ranges::count(ties, 1) == 0)
        return ties;
    const std::vector<Picture> pictures = picturesOfAllRules(scene);
    for (std::size_t place = 0; place < ties.size(); ++place) {
        const auto isIn = [&](const Picture &other) { return isSame(other, found, place); };
        ties[place] = ties[place] != 0 && std::ranges::any_of(pictures, isIn) ? 1 : 0;
    }
    return ties;
}

/// The pixels of lines in right programs that differ only at p = 0, where two pixels are equally
/// near: they step across there or not, from either end.
std::vector<std::uint8_t> ofOtherTies(const Scene &scene, const Picture &drawn,
                                      const Picture &found)
{
    const Scene other = withOtherTies(scene);
    const ProgramLine fromFirstEnd;
    const std::array pictures
        = {pictureOf(other), drawnBy(fromFirstEnd, scene), drawnBy(fromFirstEnd, other)};
    std::vector<std::uint8_t> ties(found.size(), 0);
    for (std::size_t place = 0; place < ties.size(); ++place) {
        const auto isIn = [&](const Picture &picture) { return isSame(picture, found, place); };
        ties[place] = !isSame(drawn, found, place) && std::ranges::any_of(pictures, isIn) ? 1 : 0;
    }
    return ties;
}

} // namespace

std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, Arithmetic arithmetic)
{
    if (hasDecisions(scene))
        return ofOtherTies(scene, drawn, found);
    if (mayCallForEffects(scene) || !scene.shapes.empty())
        return ofAnotherRule(scene, drawn, found);
    LayeredLeeway leeway(scene, drawn, found);
    const Primitives primitives = primitivesOnSamples(scene);
    for (std::size_t i = primitives.triangles.size(); i-- > 0;)
        leeway.takeOff(
            TriangleLeeway(primitives.triangles[i], arithmetic, scene.settings.rounding));
    return leeway.pixels();
}

} // namespace pixelplumb
