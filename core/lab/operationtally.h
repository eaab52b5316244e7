// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/operationcounts.h"

#include <utility>

namespace pixelplumb {

/// Where counting numbers count: one in hand in each thread while it lives. What changes or asks
/// for the one in hand is not inline: there is one such place in a process, also where a program
/// and the core would each have its own. count() stands beside every operation of every kernel that
/// counts besides, and would be half of what the compiler has to do there.
class OperationTally {
public:
    OperationTally();
    ~OperationTally();
    OperationTally(const OperationTally &) = delete;
    OperationTally &operator=(const OperationTally &) = delete;

    static void count(Operation operation, std::int64_t times = 1);

    WorkStage enter(WorkStage stage) { return std::exchange(m_stage, stage); }
    void beginPrimitive() { m_stage = WorkStage::SetUp; }

    OperationCounts counts;

private:
    OperationTally *m_before;
    WorkStage m_stage = WorkStage::SetUp;
};

} // namespace pixelplumb
