// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationcounts.h"

#include <utility>

namespace pixelplumb {

/// Where counting numbers count: each thread has one current tally while it lives. What changes or
/// reads the current tally is not inline, so that a process has one, even where a program and the
/// core would each have their own. Besides, count() is called at every operation of every counting
/// kernel, and inline it would be half of the compiler's work there.
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
