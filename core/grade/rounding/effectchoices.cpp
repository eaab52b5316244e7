// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/effectchoices.h"

#include "core/frame/framebuffer.h"
#include "core/grade/rounding/samplechoices.h"
#include "core/grade/rounding/trianglemargin.h"
#include "core/methods/stroketruth.h"
#include "core/oracle/effectoracle.h"
#include "core/oracle/truepicture.h"
#include "core/runs/contender.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The colours of a pixel in which only some of the triangles are drawn.
class PixelColours {
public:
    PixelColours(const Scene &scene, const Margin &margin)
        : m_run(scene)
        , m_plan(planOf(m_run))
    {
        m_run.settings.fillRule = FillRule::Closed;
        for (const Triangle &triangle : triangles())
            m_margins.emplace_back(triangle, scene, margin);
    }

    const std::vector<Triangle> &triangles() const { return m_run.primitives.triangles; }
    bool isAntialiased() const { return m_plan.runs(Effect::Antialiasing); }

    bool mayBe(const Colour &colour, const SampleChoice &choice,
               const std::vector<std::size_t> &drawn)
    {
        return isBlendedAlone() ? isBlendOf(colour, choice, drawn)
                                : colour == trueColour(choice, drawn);
    }

private:
    bool isBlendedAlone() const
    {
        constexpr std::array others = {Effect::Depth, Effect::Perspective, Effect::Texture,
                                       Effect::Light, Effect::Antialiasing};
        const auto hasOneAlpha = [](const TriangleAttributes &attributes) {
            const auto &[a, b, c] = attributes.vertices;
            return a.alpha == b.alpha && b.alpha == c.alpha;
        };
        return std::ranges::none_of(others, [this](Effect each) { return m_plan.runs(each); })
            && m_run.primitives.shapes.empty()
            && oracle::truthOf(m_run.primitives.appearance).smooth
            && std::ranges::all_of(m_run.primitives.attributes, hasOneAlpha);
    }

    /// Blending grows with both colours, so that the bounds are the blends of bounds.
    bool isBlendOf(const Colour &colour, const SampleChoice &choice,
                   const std::vector<std::size_t> &drawn) const
    {
        const bool isBlended = oracle::truthOf(m_run.primitives.appearance).blending;
        ColourRange range{m_run.scene.frame.background, m_run.scene.frame.background};
        for (const std::size_t triangle : drawn) {
            const auto own = m_margins[triangle].coloursAt(choice.x(), choice.y());
            const std::uint8_t alpha
                = isBlended ? oracle::attributesOf(m_run.primitives, triangle)[0].alpha : 255;
            range = {oracle::blended(own.least, alpha, range.least),
                     oracle::blended(own.most, alpha, range.most)};
        }
        return range.contains(colour);
    }

    Colour trueColour(const SampleChoice &choice, const std::vector<std::size_t> &drawn)
    {
        const std::vector<Triangle> kept = m_run.primitives.triangles;
        for (const std::size_t triangle : choice.open()) {
            if (!std::ranges::binary_search(drawn, triangle)) {
                for (Vertex &vertex : m_run.primitives.triangles[triangle].vertices)
                    vertex.position = latticePixel(choice.x() - 8, choice.y() - 8);
            }
        }
        QRgb pixel = packed(m_run.scene.frame.background);
        FrameView view = windowOf(m_run.scene.frame);
        view.base = &pixel;
        view.stride = 1;
        view.firstColumn = std::int32_t(choice.x());
        view.firstRow = std::int32_t(choice.y());
        view.width = view.height = 1;
        oracle::drawPicture(m_run.primitives, m_run.settings, &m_plan, view,
                            strokeTruthOf(m_run.method));
        m_run.primitives.triangles = kept;
        return unpacked(pixel);
    }

    SceneRun m_run;
    EffectPlan m_plan; ///< under the scene's own rule
    std::vector<TriangleMargin> m_margins;
};

/// The scene under each rule that its method knows and the leeway allows, displaced in every
/// direction where a rule can be.
std::vector<Picture> picturesOfAllRules(Scene scene, Leeway leeway)
{
    std::vector<Picture> pictures;
    const auto add = [&] {
        const SceneRun run(scene);
        if (objectionTo(run).isEmpty())
            pictures.push_back(pictureOf(run));
    };
    for (const FillRule rule : allFillRules) {
        if (leeway == Leeway::Once && !isWatertight(rule))
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
    return pictures;
}

std::vector<std::uint8_t> ofOtherRules(const Scene &scene, const Picture &found,
                                       std::vector<std::uint8_t> differing, Leeway leeway)
{
    const bool isOpen = leeway == Leeway::Edges || leeway == Leeway::Once;
    const auto pictures = isOpen ? picturesOfAllRules(scene, leeway) : std::vector<Picture>();
    for (std::size_t place = 0; place < differing.size(); ++place) {
        const auto isIn = [&](const Picture &other) { return isSameAt(other, found, place); };
        differing[place] = differing[place] != 0 && std::ranges::any_of(pictures, isIn) ? 1 : 0;
    }
    return differing;
}

} // namespace

std::vector<std::uint8_t> ofOtherTriangles(const Scene &scene, const Picture &drawn,
                                           const Picture &found, const Margin &margin)
{
    std::vector<std::uint8_t> differing(found.size(), 0);
    for (std::size_t place = 0; place < found.size(); ++place)
        differing[place] = isSameAt(drawn, found, place) ? 0 : 1;
    PixelColours colours(scene, margin);
    if (colours.isAntialiased())
        return ofOtherRules(scene, found, std::move(differing), margin.leeway);
    std::vector<std::uint8_t> open(found.size(), 0);
    std::vector<std::uint8_t> bare(found.size(), 0);
    for (const SampleChoice &choice :
         sampleChoicesOf(colours.triangles(), scene, margin, differing)) {
        const std::size_t place = choice.placeIn(scene.frame);
        for (const std::vector<std::size_t> &set : choice.sets(margin.leeway)) {
            const bool isOf = found.hasColours ? colours.mayBe(found.colours[place], choice, set)
                                               : (found.covered[place] != 0) == !set.empty();
            if (isOf)
                (set.empty() ? bare : open)[place] = 1;
        }
        bare[place] = bare[place] != 0 && open[place] == 0 ? 1 : 0;
    }
    const std::vector<std::uint8_t> holes = holesAmong(bare, scene, margin);
    for (std::size_t place = 0; place < open.size(); ++place)
        open[place] = open[place] != 0 || (bare[place] != 0 && holes[place] == 0) ? 1 : 0;
    return open;
}

} // namespace pixelplumb
