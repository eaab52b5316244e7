// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/studyprogress.h"

#include "core/scan/choicenames.h"

namespace pixelplumb::cli {

void StudyProgress::show(const JobProgress &told)
{
    const double within = told.total == 0 ? 0 : double(told.done) / double(told.total);
    const double done = (within + (told.phase == JobPhase::Measuring ? 1 : 0)) / 2;
    QString text = nameText(nameOf(told.phase)) + QStringLiteral(": %1 %").arg(int(100 * done));
    if (done > 0.05) {
        const double left = double(m_clock.elapsed()) * (1 - done) / done / 1000;
        text += QStringLiteral(", about %1 s left").arg(int(left) + 1);
    }
    m_progress.show(text);
}

} // namespace pixelplumb::cli
