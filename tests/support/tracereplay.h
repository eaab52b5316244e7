// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The picture that the changes of a trace make, one after the other.
QImage replayed(const ScanTrace &trace, const FrameSpec &frame);

} // namespace pixelplumb
