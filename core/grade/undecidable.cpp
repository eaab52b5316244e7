// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/undecidable.h"

#include "core/frame/framebuffer.h"
#include "core/grade/linechoice.h"
#include "core/grade/outlineties.h"
#include "core/grade/picturediff.h"
#include "core/grade/triangleleeway.h"
#include "core/runs/sceneplan.h"

#include <algorithm>
#include <iterator>
#include <ranges>

namespace pixelplumb {

namespace {

/// What is known of a pixel while primitives are removed one by one, the last drawn first.
enum class Leeway : std::uint8_t {
    Sought, ///< no removed primitive reaches it
    Open, ///< the removed primitives may have left it out
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
                const std::size_t place = placeOf(x, y);
                if (isLookedFor(place))
                    m_pixels[place] = leewayBelow(
                        triangle.containmentOf(x, y), place,
                        [&](const Colour &colour) { return triangle.mayHave(colour, x, y); });
            }
        }
    }
    void takeOff(const LineChoice &choice)
    {
        const Containment where
            = choice.pixels.size() == 1 ? Containment::Inside : Containment::Undecided;
        for (const LatticePoint &pixel : choice.pixels) {
            if (isInFrame(pixel) && isLookedFor(placeOf(pixel.x, pixel.y)))
                m_pixels[placeOf(pixel.x, pixel.y)]
                    = leewayBelow(where, placeOf(pixel.x, pixel.y), [&](const Colour &colour) {
                          return choice.mayHave(colour, m_scene.settings.rounding);
                      });
        }
    }
    /// Of a step's pixels one is drawn, neither none nor two: refuses the pixels of the others,
    /// where nothing else can have drawn them.
    void refuseAllButOne(const std::vector<LineChoice> &choices)
    {
        std::vector<int> steps(m_found.size(), 0);
        for (const LineChoice &choice : choices) {
            for (const LatticePoint &pixel : choice.pixels)
                steps[isInFrame(pixel) ? placeOf(pixel.x, pixel.y) : 0] += isInFrame(pixel) ? 1 : 0;
        }
        for (const LineChoice &choice : choices) {
            std::vector<std::size_t> places;
            for (const LatticePoint &pixel : choice.pixels) {
                if (isInFrame(pixel))
                    places.push_back(placeOf(pixel.x, pixel.y));
            }
            const auto isDrawn = [this](std::size_t place) { return !isBackground(place); };
            const bool isOwn = places.size() == choice.pixels.size()
                && std::ranges::all_of(places, [&](std::size_t each) { return steps[each] == 1; });
            if (!isOwn || std::ranges::count_if(places, isDrawn) == 1)
                continue;
            for (const std::size_t place : places)
                m_pixels[place] = Leeway::Refused;
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
    bool isInFrame(const LatticePoint &pixel) const
    {
        const FrameSpec &frame = m_scene.frame;
        return pixel.x >= frame.firstColumn && pixel.x - frame.firstColumn < frame.width
            && pixel.y >= frame.firstRow && pixel.y - frame.firstRow < frame.height;
    }
    std::size_t placeOf(std::int64_t x, std::int64_t y) const
    {
        return m_found.placeOf(int(x - m_scene.frame.firstColumn),
                               int(pictureLine(m_scene.frame, y)));
    }
    bool isLookedFor(std::size_t place) const
    {
        return m_pixels[place] == Leeway::Sought || m_pixels[place] == Leeway::Open;
    }
    bool isBackground(std::size_t place) const
    {
        return m_found.covered[place] == 0
            || (m_found.hasColours && m_found.colours[place] == m_scene.frame.background);
    }
    template <class MayHave>
    Leeway leewayBelow(Containment where, std::size_t place, const MayHave &mayHave) const
    {
        if (where == Containment::Outside)
            return m_pixels[place];
        // A raster has no colours: inside, nothing of it is open.
        const bool isInside = where == Containment::Inside;
        const bool isOf = m_found.hasColours
            ? mayHave(m_found.colours[place])
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

/// Takes off the steps of all lines, the last drawn first.
void takeOffLines(const Scene &scene, Arithmetic arithmetic, LayeredLeeway &leeway)
{
    std::vector<LineChoice> choices;
    for (const Shape &line : primitivesOnSamples(scene).shapes)
        std::ranges::move(lineChoices(line, scene, arithmetic), std::back_inserter(choices));
    for (const LineChoice &choice : choices | std::views::reverse)
        leeway.takeOff(choice);
    leeway.refuseAllButOne(choices);
}

} // namespace

std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, Arithmetic arithmetic)
{
    LayeredLeeway leeway(scene, drawn, found);
    if (drawsNearestPixels(scene)) {
        takeOffLines(scene, arithmetic, leeway);
        return leeway.pixels();
    }
    if (mayCallForEffects(scene) || !scene.shapes.empty())
        return ofAnotherRule(scene, drawn, found);
    if (scene.method == "midpoint-outline-fill")
        return ofOtherOutlines(scene, drawn, found, arithmetic);
    const Primitives primitives = primitivesOnSamples(scene);
    for (std::size_t i = primitives.triangles.size(); i-- > 0;)
        leeway.takeOff(
            TriangleLeeway(primitives.triangles[i], arithmetic, scene.settings.rounding));
    return leeway.pixels();
}

} // namespace pixelplumb
