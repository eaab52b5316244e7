// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/operationtally.h"

namespace pixelplumb {

namespace {

thread_local OperationTally *current = nullptr;

} // namespace

OperationTally::OperationTally()
    : m_before(std::exchange(current, this))
{
}

OperationTally::~OperationTally() { current = m_before; }

void OperationTally::count(Operation operation, std::int64_t times)
{
    if (current)
        current->counts.stages[std::size_t(current->m_stage)][std::size_t(operation)] += times;
}

} // namespace pixelplumb
