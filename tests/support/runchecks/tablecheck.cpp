// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/casestorun.h"
#include "tests/support/programs/tablefolder.h"
#include "tests/support/runchecks/runcheck.h"

namespace pixelplumb {

namespace {

/// One run in this many is kept for another program to read; all if all cases are run.
constexpr std::size_t keptShare = 4;

} // namespace

RunCheck tableCheck(TableFolder &folder)
{
    const auto runs = std::make_shared<std::size_t>(0);
    return {u"every table of the run can be read"_s, [&folder, runs](const CheckedRun &run) {
                // The tables of runs with effects belong to the tests of effects and of the trace
                // command.
                if (run.traced->shading())
                    return QString();
                return (*runs)++ % keptShare == 0 || areAllCasesRun()
                    ? folder.faultOfKept(*run.traced, run.name)
                    : folder.faultOf(*run.traced);
            }};
}

} // namespace pixelplumb
