// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

namespace pixelplumb {

/// What determines the stages of a triangle's samples.
struct StageNeeds {
    InterpolationForm form = InterpolationForm::Bilinear;
    EffectSet effects;
    TextureFilter filter = TextureFilter::Nearest;
    bool coversAreas = false; ///< samples may lie outside the triangle
    bool isRead = false; ///< an observer reads the numbers; then no stage writes the pixels
};

/// One operation on all samples in play of a run.
template <class N>
using Stage = void (*)(StagedSamples<N> &run);

/// The stages that a plan calls for on one triangle, in order. Nothing else is in the list, so
/// nothing else runs.
template <class N>
class StageList {
public:
    explicit StageList(const StageNeeds &needs);

    void operator()(StagedSamples<N> &run) const
    {
        run.carried = &m_carried;
        for (std::size_t i = 0; i < m_count && run.count > 0; ++i)
            m_stages[i](run);
    }

private:
    static constexpr std::size_t most = 9;
    ShadedChannels m_carried;
    std::array<Stage<N>, most> m_stages = {};
    std::size_t m_count = 0;
};

extern template class StageList<FloatShading<float>>;
extern template class StageList<FloatShading<double>>;
extern template class StageList<ExactShading<Int128>>;
extern template class StageList<ExactShading<Int256>>;

} // namespace pixelplumb
