// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/operationcounts.h"

#include <utility>

namespace pixelplumb {

/// Where counting numbers count: one in hand in each thread while it lives.
class OperationTally {
public:
    OperationTally()
        : m_before(std::exchange(inHand, this))
    {
    }
    ~OperationTally() { inHand = m_before; }
    OperationTally(const OperationTally &) = delete;
    OperationTally &operator=(const OperationTally &) = delete;

    /// Not inline: it stands beside every operation of every kernel that counts, and would be half
    /// of what the compiler has to do there.
    static void count(Operation operation, std::int64_t times = 1);

    WorkStage enter(WorkStage stage) { return std::exchange(m_stage, stage); }
    void beginPrimitive() { m_stage = WorkStage::SetUp; }

    OperationCounts counts;

private:
    static inline thread_local OperationTally *inHand = nullptr;

    OperationTally *m_before;
    WorkStage m_stage = WorkStage::SetUp;
};

} // namespace pixelplumb
