// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"

#include <functional>

namespace pixelplumb::bench {

/// The lab's study (core/lab/study/study.h) extended by the line-up's renderers that draw smooth
/// triangles on one thread, as the JSON that the lab opens. Each is judged under the tie rule that
/// its pictures follow.
QByteArray studyWithPeers(const Lineup &lineup, Extent extent,
                          const std::function<void(const QString &)> &progress);

} // namespace pixelplumb::bench
