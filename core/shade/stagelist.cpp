// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/stagelist.h"

#include "core/shade/blendstage.h"
#include "core/shade/colourstage.h"
#include "core/shade/depthstage.h"
#include "core/shade/dividestage.h"
#include "core/shade/interpolatestage.h"
#include "core/shade/lightstage.h"
#include "core/shade/texelstage.h"
#include "core/shade/writestage.h"

namespace pixelplumb {

namespace {

/// A stage and when a plan calls for it.
template <class N>
struct StageRow {
    bool (*isCalledFor)(const StageNeeds &needs);
    Stage<N> stage;
};

template <InterpolationForm form>
bool interpolates(const StageNeeds &needs)
{
    return needs.form == form && (needs.isRead || needs.effects != EffectSet{});
}

template <TextureFilter filter>
bool reads(const StageNeeds &needs)
{
    return needs.effects.texture && needs.filter == filter;
}

/// Whether the triangle has one colour that nothing changes.
bool paints(const StageNeeds &needs)
{
    const EffectSet &effects = needs.effects;
    return !effects.smooth && !effects.perspective && !effects.texture && !effects.light
        && !effects.blending && !needs.isRead;
}

/// Whether depth is compared in this way by a separate stage; paintsBy() is for the stages that
/// also paint.
template <DepthTest test>
bool compares(const StageNeeds &needs)
{
    return needs.effects.depth == test && !paints(needs);
}
template <DepthTest test>
bool paintsBy(const StageNeeds &needs)
{
    return needs.effects.depth == test && paints(needs);
}

using Needs = StageNeeds;
/// In the order in which they run.
template <class N>
constexpr StageRow<N> table[] = {
    {interpolates<InterpolationForm::Bilinear>, stages::interpolateByAdding<N>},
    {interpolates<InterpolationForm::Plane>, stages::interpolateByPlanes<N>},
    {interpolates<InterpolationForm::Barycentric>, stages::interpolateByWeights<N>},
    {[](const Needs &needs) { return needs.effects.perspective && needs.coversAreas; },
     stages::leaveHorizon<N>},
    {paintsBy<DepthTest::None>, stages::paint<N>},
    {paintsBy<DepthTest::Number>, stages::paintNearer<N, stages::DepthNumbers<N>>},
    {paintsBy<DepthTest::Levels>, stages::paintNearer<N, stages::DepthLevels<N>>},
    {compares<DepthTest::Number>, stages::compareDepth<N, stages::DepthNumbers<N>>},
    {compares<DepthTest::Levels>, stages::compareDepth<N, stages::DepthLevels<N>>},
    {[](const Needs &needs) { return needs.effects.perspective; }, stages::divideByW<N>},
    {[](const Needs &needs) { return !needs.effects.smooth && !paints(needs); },
     stages::setFlatColour<N>},
    {[](const Needs &needs) { return needs.effects.smooth; }, stages::setSmoothColour<N>},
    {reads<TextureFilter::Nearest>, stages::tintByTexels<TextureFilter::Nearest, N>},
    {reads<TextureFilter::Bilinear>, stages::tintByTexels<TextureFilter::Bilinear, N>},
    {[](const Needs &needs) { return needs.effects.light; }, stages::light<N>},
    {[](const Needs &needs) { return needs.effects.blending; }, stages::blend<N>},
    {[](const Needs &needs) { return !needs.isRead && !paints(needs); }, stages::write<N>},
};

} // namespace

template <class N>
StageList<N>::StageList(const StageNeeds &needs)
    : m_carried(needs.effects)
{
    for (const StageRow<N> &row : table<N>) {
        if (row.isCalledFor(needs))
            m_stages[m_count++] = row.stage;
    }
}

template class StageList<FloatShading<float>>;
template class StageList<FloatShading<double>>;
template class StageList<ExactShading<Int128>>;
template class StageList<ExactShading<Int256>>;

} // namespace pixelplumb
