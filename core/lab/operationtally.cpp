// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/operationtally.h"

namespace pixelplumb {

namespace {

thread_local OperationTally *inHand = nullptr;

} // namespace

OperationTally::OperationTally()
    : m_before(std::exchange(inHand, this))
{
}

OperationTally::~OperationTally() { inHand = m_before; }

void OperationTally::count(Operation operation, std::int64_t times)
{
    if (inHand)
        inHand->counts.stages[std::size_t(inHand->m_stage)][std::size_t(operation)] += times;
}

} // namespace pixelplumb
