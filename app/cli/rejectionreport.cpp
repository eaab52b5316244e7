// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rejectionreport.h"

#include "app/cli/console.h"

#include <algorithm>

namespace pixelplumb::cli {

void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected)
{
    constexpr std::size_t mostReported = 5;
    const std::size_t reported = std::min(rejected.size(), mostReported);
    for (std::size_t i = 0; i < reported; ++i)
        sayLine(drawnBy + QStringLiteral(": ") + rejected[i].message());
    if (rejected.size() > reported)
        sayLine(QStringLiteral("%1: %2 more primitives are not drawn")
                    .arg(drawnBy, QString::number(rejected.size() - reported)));
}

} // namespace pixelplumb::cli
