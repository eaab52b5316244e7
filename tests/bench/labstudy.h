// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"

#include <functional>

namespace pixelplumb::bench {

/// The lab's study (core/lab/study.h) with the renderers of the line-up that draw smooth triangles
/// on one thread among its contenders, as the JSON that the lab opens. Each is judged under the
/// rule of ties that its pictures follow.
QByteArray studyWithPeers(const Lineup &lineup, Extent extent,
                          const std::function<void(const QString &)> &progress);

} // namespace pixelplumb::bench
