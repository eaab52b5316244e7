// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

namespace pixelplumb {

/// Two contenders on the current scene, timed briefly.
inline StudySettings smallRequest()
{
    StudySettings request;
    request.families = {u"own-scene"_s};
    request.rounds = 2;
    for (const char *id : {"column-scan:exact", "column-scan:float32"})
        request.contenders.push_back(*labContenderNamed(QLatin1String(id)));
    return request;
}

} // namespace pixelplumb
