// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The picture made by applying the changes of a trace in order.
QImage replayed(const ScanTrace &trace, const FrameSpec &frame);

} // namespace pixelplumb
