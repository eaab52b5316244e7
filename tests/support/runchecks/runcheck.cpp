// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/runcheck.h"

namespace pixelplumb {

std::vector<RunCheck> runChecks(TableFolder &folder)
{
    std::vector<RunCheck> checks;
    for (std::vector<RunCheck> &part : std::vector{pictureChecks(), recordChecks(), wordChecks()})
        std::ranges::move(part, std::back_inserter(checks));
    checks.push_back(formulaCheck());
    checks.push_back(pseudocodeCheck());
    checks.push_back(tableCheck(folder));
    checks.push_back(choiceCheck());
    return checks;
}

} // namespace pixelplumb
