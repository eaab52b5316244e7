// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

const ReportRow *WorkloadReport::row(const QString &contenderId) const
{
    for (const ReportRow &row : rows) {
        if (row.result.contender->info().id == contenderId)
            return &row;
    }
    return nullptr;
}

QStringList Report::brokenPromises() const
{
    QStringList broken;
    for (const WorkloadReport &workload : workloads) {
        for (const ReportRow &row : workload.rows) {
            const ContenderInfo &info = row.result.contender->info();
            const auto add = [&](double share, const char *truth) {
                if (share == 0)
                    return;
                broken << u"%1: %2 promises the true picture; %3 % of its pixels are "
                          "not the %4's."_s.arg(workload.id, info.name)
                              .arg(share * 100, 0, 'g', 3)
                              .arg(QLatin1String(truth));
            };
            if (info.exactUnder() && row.picture)
                add(row.picture->bytes, "oracle");
            if (row.differsFromPlain)
                add(*row.differsFromPlain, "plain kernel");
        }
    }
    return broken;
}

} // namespace pixelplumb::bench
