// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/model/playhead.h"

#include <algorithm>

/// Tracks what has been seen and can no longer be predicted.
namespace pixelplumb {

namespace {

constexpr std::size_t mostScenesSeen = 16; ///< of edits that are undone and redone

} // namespace

bool PredictPanel::hasBeenSeen() const
{
    const TracedScene *traced = m_playhead->traced();
    const std::size_t step = place().step;
    if (!traced || m_seen.empty() || step >= traced->trace->stepCount())
        return false;
    return prediction() ? traced->trace->stepAt(step).span < m_seen.back().spans
                        : step < m_seen.back().position;
}

void PredictPanel::beginSeen()
{
    const TracedScene *traced = m_playhead->traced();
    if (!isOpen() || !traced)
        return;
    Scene scene = traced->scene;
    scene.settings = {};
    const auto known = std::ranges::find(m_seen, scene, &Seen::scene);
    if (known != m_seen.end())
        std::rotate(known, known + 1, m_seen.end());
    else
        m_seen.push_back({std::move(scene)});
    if (m_seen.size() > mostScenesSeen)
        m_seen.erase(m_seen.begin());
}

void PredictPanel::goTo(std::size_t position)
{
    if (isOpen() && !m_seen.empty()) {
        Seen &seen = m_seen.back();
        if (const std::optional<std::size_t> span = m_playhead->currentSpan())
            seen.spans = std::max(seen.spans, *span + 1);
        seen.position = std::max(seen.position, position);
    }
    listQuestions();
}

} // namespace pixelplumb
