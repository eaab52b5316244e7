// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

/// A playhead at the beginning of a scene's run.
class TracedPlayhead : public Playhead {
public:
    explicit TracedPlayhead(const std::shared_ptr<const TracedScene> &run) { setTraced(run); }
    explicit TracedPlayhead(const Scene &scene)
        : TracedPlayhead(traceScene(scene))
    {
    }
};

} // namespace pixelplumb
