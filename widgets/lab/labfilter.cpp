// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labfilter.h"

namespace pixelplumb {

bool LabFilter::leavesOut(const QString &contender) const
{
    if (kernels.contains(kernelOf(contender)) || methods.contains(contender.section(u':', 0, 0)))
        return true;
    const std::optional<LabContender> known = labContenderNamed(contender);
    return known && arithmetics.contains(known->arithmetic);
}

std::shared_ptr<const Study> filtered(const std::shared_ptr<const Study> &results,
                                      const LabFilter &filter)
{
    if (!results || filter.leavesNobodyOut())
        return results;
    auto kept = std::make_shared<Study>(*results);
    const auto isOut = [&filter](const QString &contender) { return filter.leavesOut(contender); };
    std::erase_if(kept->contenders, [&](const StudyContender &each) { return isOut(each.id); });
    std::erase_if(kept->rows, [&](const LabRow &each) { return isOut(each.contender); });
    if (filter.straightLoops == LabFilter::StraightLoops::LeftOut) {
        for (LabRow &row : kept->rows) {
            if (row.cost)
                row.cost->straight.reset();
        }
    }
    return kept;
}

} // namespace pixelplumb
