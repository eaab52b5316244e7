// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/undecidable.h"

#include "core/frame/framebuffer.h"
#include "core/grade/linechoice.h"
#include "core/grade/outlineties.h"
#include "core/grade/picturediff.h"
#include "core/grade/sharedsamples.h"
#include "core/grade/trianglemargin.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

/// What is known of a pixel while primitives are removed one by one, the last drawn first.
enum class PixelState : std::uint8_t {
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

class LayeredMargin {
public:
    LayeredMargin(const Scene &scene, const Picture &drawn, const Picture &found)
        : m_scene(scene)
        , m_found(found)
        , m_pixels(found.size(), PixelState::Sought)
        , m_areDrawnByFunctions(found.size(), 0)
    {
        for (std::size_t place = 0; place < found.size(); ++place) {
            if (isSame(drawn, found, place))
                m_pixels[place] = PixelState::Refused; // needs no margin
        }
    }

    void takeOff(const TriangleMargin &triangle)
    {
        const SampleBox box = triangle.reachIn(m_scene.frame);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place = placeOf(x, y);
                if (!isLookedFor(place))
                    continue;
                m_pixels[place]
                    = stateBelow(triangle.containmentOf(x, y), place, [&](const Colour &colour) {
                          return triangle.mayHave(colour, x, y);
                      });
                if (m_pixels[place] == PixelState::Open && triangle.isDrawnByFunctions(x, y))
                    m_areDrawnByFunctions[place] = 1;
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
                    = stateBelow(where, placeOf(pixel.x, pixel.y), [&](const Colour &colour) {
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
                m_pixels[place] = PixelState::Refused;
        }
    }
    /// Between two triangles a sample on their edge is drawn: rounding moves the edge, and what
    /// leaves one is in the other. Refused are bare pixels there, but where edge functions, which
    /// each triangle evaluates for itself, may leave it out of both.
    void refuseHoles(Leeway leeway)
    {
        const auto isBare = [this](std::size_t place) {
            return m_pixels[place] == PixelState::Open && isBackground(place);
        };
        std::vector<std::size_t> bare;
        for (std::size_t place = 0; place < m_pixels.size(); ++place) {
            if (isBare(place))
                bare.push_back(place);
        }
        if (leeway == Leeway::Edges || bare.empty())
            return;
        const std::vector<std::uint8_t> shared = sharedSamples(m_scene);
        for (const std::size_t place : bare) {
            const bool isHole = leeway == Leeway::Once || m_areDrawnByFunctions[place] != 0;
            if (shared[place] != 0 && isHole)
                m_pixels[place] = PixelState::Refused;
        }
    }
    /// A pixel that is still open counts if it shows the background.
    std::vector<std::uint8_t> pixels() const
    {
        std::vector<std::uint8_t> given(m_pixels.size(), 0);
        for (std::size_t place = 0; place < given.size(); ++place) {
            const bool isBare = m_pixels[place] == PixelState::Open && isBackground(place);
            given[place] = isBare || m_pixels[place] == PixelState::Given ? 1 : 0;
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
        return m_pixels[place] == PixelState::Sought || m_pixels[place] == PixelState::Open;
    }
    bool isBackground(std::size_t place) const
    {
        return m_found.covered[place] == 0
            || (m_found.hasColours && m_found.colours[place] == m_scene.frame.background);
    }
    template <class MayHave>
    PixelState stateBelow(Containment where, std::size_t place, const MayHave &mayHave) const
    {
        if (where == Containment::Outside)
            return m_pixels[place];
        // A raster has no colours: inside, nothing of it is open.
        const bool isInside = where == Containment::Inside;
        const bool isOf = m_found.hasColours
            ? mayHave(m_found.colours[place])
            : m_found.covered[place] != 0 && (!isInside || m_pixels[place] == PixelState::Open);
        if (isOf)
            return PixelState::Given;
        return isInside ? PixelState::Refused : PixelState::Open;
    }

    const Scene &m_scene;
    const Picture &m_found;
    std::vector<PixelState> m_pixels;
    /// By a triangle that other programs may leave out there.
    std::vector<std::uint8_t> m_areDrawnByFunctions;
};

/// The scene under each rule that its method knows, displaced in every direction where a rule can
/// be, and without each of its triangles.
std::vector<Picture> picturesOfAllRules(Scene scene, Leeway leeway)
{
    std::vector<Picture> pictures;
    const auto add = [&] {
        if (objectionTo(scene).isEmpty())
            pictures.push_back(pictureOf(scene));
    };
    for (const FillRule rule : allFillRules) {
        const bool isOnce = rule != FillRule::Closed && rule != FillRule::Open;
        if (leeway == Leeway::Once && !isOnce)
            continue;
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

/// A 1 for each sample on an edge that the margin leaves open.
std::vector<std::uint8_t> openTiesOf(const Scene &scene, const Margin &margin)
{
    std::vector<std::uint8_t> ties = tiesOf(scene);
    if (margin.leeway != Leeway::Rule)
        return ties;
    std::vector<std::uint8_t> open(ties.size(), 0);
    for (const Triangle &triangle : primitivesOnSamples(scene).triangles) {
        const TriangleMargin own(triangle, scene, margin);
        const SampleBox box = intersection(boundingBoxOf(triangle), own.reachIn(scene.frame));
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place
                    = std::size_t(pictureLine(scene.frame, y)) * std::size_t(scene.frame.width)
                    + std::size_t(x - scene.frame.firstColumn);
                if (ties[place] != 0 && own.containmentOf(x, y) == Containment::Undecided)
                    open[place] = 1;
            }
        }
    }
    return open;
}

std::vector<std::uint8_t> ofAnotherRule(const Scene &scene, const Picture &drawn,
                                        const Picture &found, const Margin &margin)
{
    std::vector<std::uint8_t> ties = openTiesOf(scene, margin);
    for (std::size_t place = 0; place < ties.size(); ++place)
        ties[place] = ties[place] != 0 && !isSame(drawn, found, place) ? 1 : 0;
    if (std::ranges::count(ties, 1) == 0)
        return ties;
    const std::vector<Picture> pictures = picturesOfAllRules(scene, margin.leeway);
    for (std::size_t place = 0; place < ties.size(); ++place) {
        const auto isIn = [&](const Picture &other) { return isSame(other, found, place); };
        ties[place] = ties[place] != 0 && std::ranges::any_of(pictures, isIn) ? 1 : 0;
    }
    return ties;
}

/// Takes off the steps of all lines, the last drawn first.
void takeOffLines(const Scene &scene, Arithmetic tolerance, LayeredMargin &margins)
{
    std::vector<LineChoice> choices;
    for (const Shape &line : primitivesOnSamples(scene).shapes)
        std::ranges::move(lineChoices(line, scene, tolerance), std::back_inserter(choices));
    std::for_each(choices.rbegin(), choices.rend(),
                  [&margins](const LineChoice &choice) { margins.takeOff(choice); });
    margins.refuseAllButOne(choices);
}

} // namespace

std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, const Margin &margin)
{
    LayeredMargin margins(scene, drawn, found);
    if (margin.isStrict())
        return std::vector<std::uint8_t>(found.size(), 0);
    if (drawsNearestPixels(scene)) {
        takeOffLines(scene, margin.tolerance, margins);
        return margins.pixels();
    }
    if (mayCallForEffects(scene) || !scene.shapes.empty())
        return ofAnotherRule(scene, drawn, found, margin);
    if (scene.method == "midpoint-outline-fill")
        return ofOtherOutlines(scene, drawn, found, margin.tolerance);
    const Primitives primitives = primitivesOnSamples(scene);
    for (std::size_t i = primitives.triangles.size(); i-- > 0;)
        margins.takeOff(TriangleMargin(primitives.triangles[i], scene, margin));
    margins.refuseHoles(margin.leeway);
    return margins.pixels();
}

} // namespace pixelplumb
