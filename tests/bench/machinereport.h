// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/machine.h"

#include <QString>

#include <cstdint>

namespace pixelplumb::bench {

/// List items, with warnings in bold.
QString markdown(const MachineConditions &machine);

/// The machine's memory in bytes.
std::int64_t installedMemory();

/// Resets the process's peak memory; false if the system does not allow it.
bool resetPeakMemory();
/// The peak memory in bytes since the last reset.
std::int64_t peakMemory();
/// Bytes in use now.
std::int64_t memoryInUse();

} // namespace pixelplumb::bench
