// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/needstally.h"

#include "core/plan/bordercrossing.h"
#include "core/plan/requirements.h"
#include "core/shade/linecolours.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Adds up the primitives one by one.
class NeedsCount {
public:
    NeedsCount(const Primitives &primitives, const SampledFrame &where)
        : m_appearance(primitives.appearance)
        , m_cutAtNear(primitives.cutAtNear)
        , m_where(where)
        , m_asked{where.frame, where.rule, primitives.appearance.antialiasing, where.isExact}
        , m_strokes{where.frame, where.rule, antialiasingOf(primitives.appearance), where.isExact}
    {
        m_tally.isPart = primitives.isPart;
    }

    void add(std::size_t index, const Triangle &triangle, const TriangleAttributes *attributes)
    {
        if (hasEdgePixels(triangle, m_asked))
            m_edges.add(mostEdgePixelsOf(triangle, m_asked));
        m_tally.askedTriangles += isDrawnEitherWay(triangle, m_asked) ? 1 : 0;
        const SampleBox reach = reachOf(triangle, m_where);
        if (reach.isEmpty()) {
            ++m_tally.outside;
            return;
        }
        ++m_tally.drawn;
        ++m_tally.drawnTriangles;
        if (isPoint(triangle))
            ++m_tally.drawnPoints;
        else if (doubledArea(triangle) == 0)
            ++m_tally.drawnSegments;
        const std::int64_t pixels = mostPixelsOf(triangle, reach, m_where.antialiasingOf(triangle));
        addClipping(borderCrossingOf(triangle, m_where), pixels, isCutAtNear(index));
        const TriangleNeeds needs = needsOf(triangle, attributes, m_appearance);
        const auto addIf = [&](bool isNeeded, Effect effect) {
            if (isNeeded)
                m_tally.of[effect].add(pixels);
        };
        addIf(needs.effects.smooth, Effect::SmoothColour);
        if (!attributes)
            return;
        addIf(needs.effects.perspective, Effect::Perspective);
        addIf(needs.effects.texture, Effect::Texture);
        addIf(needs.effects.light || needs.vertexLight, Effect::Light);
        addIf(needs.effects.blending, Effect::Blending);
        addDetails(triangle, *attributes, needs);
    }

    /// Called once all triangles are added: the edges of one that lies between all samples divide
    /// the pixels of others, if there are any.
    void endTriangles()
    {
        if (m_tally.askedTriangles > 0)
            m_tally.of[Effect::Antialiasing] = m_edges;
    }

    void add(const Shape &shape)
    {
        if (callsForAntialiasing(shape, m_asked))
            m_tally.of[Effect::Antialiasing].add(mostPixelsOf(shape, m_where.frame));
        const BorderCrossing crossing
            = borderCrossingOf(shape, isStroke(shape) ? m_strokes : m_where);
        if (isStroke(shape)) {
            const bool isForced = m_strokes.antialiasing != m_asked.antialiasing;
            const BorderCrossing asked = isForced ? borderCrossingOf(shape, m_asked) : crossing;
            m_tally.askedStrokes += asked != BorderCrossing::Outside ? 1 : 0;
        }
        if (crossing == BorderCrossing::Outside) {
            ++m_tally.outside;
            return;
        }
        ++m_tally.drawn;
        addClipping(crossing, pixelsOfFrame(), false);
        const auto differs
            = [&](const Vertex &vertex) { return vertex.colour != shape.vertices.front().colour; };
        if (isSmoothLine(shape))
            m_tally.of[Effect::SmoothColour].add(mostPixelsOf(shape, m_where.frame));
        else if (std::ranges::any_of(shape.vertices, differs))
            ++m_tally.ownColours;
    }

    const NeedsTally &tally() const { return m_tally; }

private:
    std::int64_t pixelsOfFrame() const
    {
        return std::int64_t(m_where.frame.width) * m_where.frame.height;
    }

    bool isCutAtNear(std::size_t triangle) const
    {
        return std::ranges::binary_search(m_cutAtNear, triangle);
    }

    void addClipping(BorderCrossing crossing, std::int64_t pixels, bool isCut)
    {
        const bool crosses = crossing == BorderCrossing::Crosses;
        m_tally.crossing += crosses ? 1 : 0;
        m_tally.cutAtNear += isCut ? 1 : 0;
        const bool mayCross = crossing == BorderCrossing::MayCross;
        if (crosses || isCut || mayCross)
            m_tally.of[Effect::Clipping].add(pixels);
        m_tally.mayCross += mayCross ? 1 : 0;
    }

    void addDetails(const Triangle &triangle, const TriangleAttributes &attributes,
                    const TriangleNeeds &needs)
    {
        const auto isSeen
            = [this](Effect effect) { return m_appearance.forced[effect] != Forcing::Off; };
        if (needs.effects.perspective) {
            m_tally.carried.carriesColour |= needs.carriesColour;
            m_tally.carried.carriesAlpha |= needs.carriesAlpha;
            // Where they run, both are divided even if the vertices agree in them.
            m_tally.carried.carriesTexture |= needs.effects.texture && isSeen(Effect::Texture);
            m_tally.carried.carriesLight |= needs.effects.light && isSeen(Effect::Light);
        }
        m_tally.dividingNothing += needs.wDiffers && !needs.effects.perspective ? 1 : 0;
        if (needs.effects.texture)
            addTexture(textureOf(attributes, m_appearance));
        if (!needs.effects.blending)
            return;
        m_tally.blended.push_back(&triangle);
        m_tally.lowestAlpha = std::min(m_tally.lowestAlpha, needs.lowestAlpha);
    }

    void addTexture(const Texture *texture)
    {
        constexpr std::size_t mostNamed = 3;
        std::vector<const Texture *> &textures = m_tally.textures;
        if (textures.size() < mostNamed && std::ranges::find(textures, texture) == textures.end())
            textures.push_back(texture);
    }

    const Appearance &m_appearance;
    const std::vector<std::size_t> &m_cutAtNear;
    SampledFrame m_where;
    NeedsTally::Touched m_edges; ///< of the triangles
    SampledFrame m_asked; ///< with the antialiasing that the appearance asks for
    SampledFrame m_strokes; ///< with the antialiasing that is forced, or asked for
    NeedsTally m_tally;
};

} // namespace

NeedsTally tallyNeeds(const Primitives &primitives, const SampledFrame &where)
{
    NeedsCount count(primitives, where);
    auto attributes = primitives.attributes.begin();
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        const bool hasAttributes
            = attributes != primitives.attributes.end() && attributes->triangle == i;
        count.add(i, primitives.triangles[i], hasAttributes ? &*attributes : nullptr);
        if (hasAttributes)
            ++attributes;
    }
    count.endTriangles();
    for (const Shape &shape : primitives.shapes)
        count.add(shape);
    return count.tally();
}

} // namespace pixelplumb
