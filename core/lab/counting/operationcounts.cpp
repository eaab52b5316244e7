// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/operationcounts.h"

#include "core/lab/counting/countedmethods.h"

#include <algorithm>
#include <numeric>

namespace pixelplumb {

namespace {

const CountedMethod *countedMethodOf(const Method &method)
{
    const auto hasItsId
        = [&](const CountedMethod &counted) { return method.id == QLatin1String(counted.id); };
    for (const auto &table : {countedTriangleMethods(), countedShapeMethods()}) {
        if (const auto found = std::ranges::find_if(table, hasItsId); found != table.end())
            return &*found;
    }
    return nullptr;
}

std::int64_t operationsIn(const OperationRow &row)
{
    return std::accumulate(row.begin(), row.end(), std::int64_t(0));
}

} // namespace

OperationRow OperationCounts::totals() const
{
    OperationRow sums = {};
    for (const OperationRow &row : stages) {
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += row[i];
    }
    return sums;
}

std::int64_t OperationCounts::total(WorkStage stage) const { return operationsIn(of(stage)); }

std::int64_t OperationCounts::total() const { return operationsIn(totals()); }

std::int64_t OperationCounts::timesOf(WorkStage stage) const
{
    switch (stage) {
    case WorkStage::SetUp:
        return primitives;
    case WorkStage::Span:
        return spans;
    case WorkStage::Pixel:
        return pixels + refused;
    }
    return 0;
}

double OperationCounts::perTime(WorkStage stage, Operation operation) const
{
    const std::int64_t times = timesOf(stage);
    return times == 0 ? 0 : double(of(stage, operation)) / double(times);
}

double OperationCounts::setUpShare() const
{
    const std::int64_t all = total();
    return all == 0 ? 0 : double(total(WorkStage::SetUp)) / double(all);
}

bool isCounted(const Method &method) { return countedMethodOf(method) != nullptr; }

std::optional<OperationCounts> countOperations(const Method &method, const ScanSettings &settings,
                                               const Primitives &primitives, FrameView frame,
                                               const ProgressListener &progress)
{
    const CountedMethod *counted = countedMethodOf(method);
    if (!counted)
        return std::nullopt;
    return counted->count(primitives, settings, frame, progress);
}

} // namespace pixelplumb
