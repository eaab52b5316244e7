// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <vector>

/// Of a long list of cases only a seeded random tenth is run; `tests/run --all` runs them all.
///
/// The environment variable PIXELPLUMB_TEST_CASES decides: "all", or a seed that draws another
/// tenth. Unset, the seed is 1, so every run meets the same cases. Each draw prints the variable;
/// ctest shows the output of a failed test, and that value repeats the failure.
namespace pixelplumb {

/// Whether PIXELPLUMB_TEST_CASES is "all".
bool areAllCasesRun();

/// The indices of the cases to run, ascending. `groups` names the group of each case: a tenth of
/// every group is run, rounded up, so no group is left out.
std::vector<std::size_t> placesToRun(const std::vector<QString> &groups);

/// The cases to run: a tenth of each group, in their original order. `groupOf` returns the name of
/// a case's group.
template <class Case, class GroupOf>
std::vector<Case> casesToRun(const std::vector<Case> &cases, GroupOf groupOf)
{
    std::vector<QString> groups;
    for (const Case &each : cases)
        groups.push_back(std::invoke(groupOf, each));
    std::vector<Case> run;
    for (const std::size_t place : placesToRun(groups))
        run.push_back(cases[place]);
    return run;
}

/// The cases to run when they all belong to one group.
template <class Case>
std::vector<Case> casesToRun(const std::vector<Case> &cases)
{
    return casesToRun(cases, [](const Case &) { return QString(); });
}

/// Limits RapidCheck to a tenth of its 100 random cases and fixes their seed, unless RC_PARAMS is
/// set. When all cases are run, every run draws new ones. Call it before the first check.
void drawFewerRandomCases();

} // namespace pixelplumb
