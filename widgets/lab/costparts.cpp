// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/costparts.h"

namespace pixelplumb {

std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row)
{
    const StudyContender *contender = study.contender(row.contender);
    const StudyFamily *family = study.family(row.family);
    if (!contender || !contender->fit || !family || family->timedPixels == 0)
        return std::nullopt;
    const CostFit &fit = *contender->fit;
    const auto pixels = double(family->timedPixels);
    return CostParts{fit.perTriangle * double(family->timedTriangles) / pixels,
                     fit.perColumn * double(family->timedSpans(row.contender)) / pixels,
                     fit.perPixel};
}

} // namespace pixelplumb
