// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/runchecks/runcheck.h"
#include "tests/support/scenes/scenesformethods.h"

namespace pixelplumb {

/// The methods × scenes × arithmetics. Fill rules and roundings alternate from run to run. For hard
/// cases the arithmetics alternate too, from case to case and from method to method, unless all
/// cases are run: then each gets all of them.
class CheckedRuns {
public:
    CheckedRuns();

    /// Traces every run of a method once, always in the same order. Skips scenes of which the
    /// method draws nothing, except the one that has all kinds of primitives.
    void forEachOf(const Method &method, const std::function<void(const CheckedRun &)> &look) const;

private:
    std::vector<NamedScene> m_scenes;
    std::vector<NamedScene> m_cases; ///< hard cases
};

/// A scene traced by the method and settings it names, with some of its steps explained.
CheckedRun checkedRunOf(const QString &name, RunOrigin origin, const Scene &scene);

} // namespace pixelplumb
