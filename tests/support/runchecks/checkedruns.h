// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/runchecks/runcheck.h"
#include "tests/support/scenesformethods.h"

namespace pixelplumb {

/// The methods × scenes × arithmetics. Fill rules and roundings take turns from run to run. Of hard
/// cases the arithmetics take turns too, from case to case and from method to method; all of them
/// where all cases are run.
class CheckedRuns {
public:
    CheckedRuns();

    /// Traces every run of a method once, in the same order each time. Scenes that the method draws
    /// nothing of are passed over, but for one that has all kinds.
    void forEachOf(const Method &method, const std::function<void(const CheckedRun &)> &look) const;

private:
    std::vector<NamedScene> m_scenes;
    std::vector<NamedScene> m_cases; ///< hard ones
};

/// A scene's run by the method and settings that it names, with some of its steps explained.
CheckedRun checkedRunOf(const QString &name, RunOrigin origin, const Scene &scene);

} // namespace pixelplumb
