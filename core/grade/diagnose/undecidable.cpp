// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/undecidable.h"

#include "core/frame/framebuffer.h"
#include "core/grade/rounding/effectchoices.h"
#include "core/grade/rounding/linechoice.h"
#include "core/grade/rounding/outlineties.h"
#include "core/grade/rounding/samplechoices.h"
#include "core/grade/rounding/trianglemargin.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace pixelplumb {

namespace {

/// What is known of a pixel while primitives are removed one by one, the last drawn first.
enum class PixelState : std::uint8_t {
    Sought, ///< no removed primitive reaches it
    Open, ///< the removed primitives may have left it out
    Refused,
    Given,
};

class LayeredMargin {
public:
    LayeredMargin(const Scene &scene, const Picture &drawn, const Picture &found)
        : m_scene(scene)
        , m_found(found)
        , m_pixels(found.size(), PixelState::Sought)
    {
        for (std::size_t place = 0; place < found.size(); ++place) {
            if (isSameAt(drawn, found, place))
                m_pixels[place] = PixelState::Refused; // needs no margin
        }
    }

    void takeOff(const TriangleMargin &triangle)
    {
        const SampleBox box = triangle.reachIn(m_scene.frame);
        const ProgramWays ways = likeliestWays(triangle, box);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place = placeOf(x, y);
                if (!isLookedFor(place))
                    continue;
                m_pixels[place] = stateBelow(
                    triangle.containmentOf(x, y, ways), place,
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
    /// A pixel that is still open counts if it shows the background and is no hole.
    std::vector<std::uint8_t> pixels(const Margin &margin) const
    {
        std::vector<std::uint8_t> bare(m_pixels.size(), 0);
        for (std::size_t place = 0; place < bare.size(); ++place)
            bare[place] = m_pixels[place] == PixelState::Open && isBackground(place) ? 1 : 0;
        const std::vector<std::uint8_t> holes = holesAmong(bare, m_scene, margin);
        std::vector<std::uint8_t> given(m_pixels.size(), 0);
        for (std::size_t place = 0; place < given.size(); ++place) {
            const bool isLeftOut = bare[place] != 0 && holes[place] == 0;
            given[place] = isLeftOut || m_pixels[place] == PixelState::Given ? 1 : 0;
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
    /// A program keeps to one way of computing a triangle: those that explain the most of what the
    /// rule would decide otherwise. What they do not explain, rounding does not.
    ProgramWays likeliestWays(const TriangleMargin &triangle, const SampleBox &box) const
    {
        std::array<int, std::numeric_limits<ProgramWays>::digits> explained = {};
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place = placeOf(x, y);
                if (!isLookedFor(place))
                    continue;
                const bool isDrawn = m_found.hasColours
                    ? triangle.mayHave(m_found.colours[place], x, y)
                    : m_found.covered[place] != 0;
                if (isDrawn == (triangle.containmentOf(x, y, {}) == Containment::Inside))
                    continue;
                const ProgramWays ways = triangle.deviatingAt(x, y);
                for (std::size_t way = 0; way < explained.size(); ++way)
                    explained[way] += int(ways >> way & 1);
            }
        }
        const int most = *std::ranges::max_element(explained);
        ProgramWays likeliest = 0;
        for (std::size_t way = 0; way < explained.size(); ++way)
            likeliest |= ProgramWays(explained[way] == most) << way;
        return likeliest;
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
};

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

/// Whether a sample that two triangles draw differs from one that one of them draws.
bool showsTwice(const Scene &scene)
{
    return mayCallForEffects(scene) && planOf(SceneRun(scene)).runs(Effect::Blending);
}

} // namespace

Scene judgedScene(const Scene &scene, const Margin &margin)
{
    const FillRule own = scene.settings.fillRule;
    const bool isSeen = own == FillRule::Open || (own == FillRule::Closed && showsTwice(scene));
    if (margin.leeway != Leeway::Once || !isSeen)
        return scene;
    for (const FillRule rule : allFillRules) {
        Scene judged = scene;
        judged.settings.fillRule = rule;
        if (isWatertight(rule) && objectionTo(judged).isEmpty())
            return judged;
    }
    return scene;
}

std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, const Margin &margin)
{
    LayeredMargin margins(scene, drawn, found);
    if (margin.isStrict())
        return std::vector<std::uint8_t>(found.size(), 0);
    if (drawsNearestPixels(scene)) {
        takeOffLines(scene, margin.tolerance, margins);
        return margins.pixels(margin);
    }
    if (mayCallForEffects(scene) || !scene.shapes.empty())
        return ofOtherTriangles(scene, drawn, found, margin);
    if (scene.method == "midpoint-outline-fill")
        return ofOtherOutlines(scene, drawn, found, margin.tolerance);
    const Primitives primitives = primitivesOnSamples(scene);
    for (std::size_t i = primitives.triangles.size(); i-- > 0;)
        margins.takeOff(TriangleMargin(primitives.triangles[i], scene, margin));
    return margins.pixels(margin);
}

} // namespace pixelplumb
