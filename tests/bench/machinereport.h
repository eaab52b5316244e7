// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/machine.h"

#include <QJsonObject>

#include <cstdint>

namespace pixelplumb::bench {

/// Lines of a list, warnings in bold.
QString markdown(const MachineConditions &machine);
QJsonObject json(const MachineConditions &machine);

/// Bytes of memory in the machine.
std::int64_t installedMemory();

/// Forgets the process's greatest memory use up to now; false where the system does not allow it.
bool resetPeakMemory();
/// Bytes, the greatest since the last reset.
std::int64_t peakMemory();
/// Bytes in use now.
std::int64_t memoryInUse();

} // namespace pixelplumb::bench
