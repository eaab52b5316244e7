// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/levelobserver.h"
#include "core/methods/edgewalkkernels.h"
#include "core/methods/outlinefill.h"

namespace pixelplumb {

std::span<const ProbedMethod> probedWalks()
{
    static constexpr ProbedMethod table[] = {
        {"column-scan", probeWith<ColumnScanKernel>},
        {"row-walk", probeWith<RowWalk>},
        {"midpoint-outline-fill", probeWith<OutlineFillKernel>},
        {"column-scan-bias", probeWith<BiasScan>},
        {"column-scan-constant-rate", probeWith<ConstantRateWalk<SpanAxis::Column>>},
        {"row-walk-constant-rate", probeWith<ConstantRateWalk<SpanAxis::Row>>},
    };
    return table;
}

} // namespace pixelplumb
