// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/operationtally.h"

namespace pixelplumb {

void OperationTally::count(Operation operation, std::int64_t times)
{
    if (inHand)
        inHand->counts.stages[std::size_t(inHand->m_stage)][std::size_t(operation)] += times;
}

} // namespace pixelplumb
