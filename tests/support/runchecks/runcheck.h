// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/explanation.h"
#include "core/runs/tracedscene.h"

#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace pixelplumb {

class TableFolder;

/// Why a run is checked.
enum class RunOrigin {
    Scene,
    Variant, ///< the method deliberately departs from the right algorithm
    HardCase,
};

/// A step of a run, explained.
struct ExplainedStep {
    TraceStep step;
    std::size_t index = 0;
    Explanation explanation;
};

/// A scene drawn by one method in one arithmetic, traced once: the input of every check.
struct CheckedRun {
    QString name; ///< "mixed, column-scan float32 closed truncate"
    RunOrigin origin = RunOrigin::Scene;
    std::shared_ptr<const TracedScene> traced;
    std::vector<ExplainedStep> steps; ///< some set-ups, spans and samples, ascending
};

/// A property that must hold for every run. It is given the runs of one method, one after the
/// other.
struct RunCheck {
    QString sentence; ///< "the picture is the truth where the method is stable"
    /// Why the property does not hold for a run; empty if it does.
    std::function<QString(const CheckedRun &)> faultOf;
    /// Why the method's runs as a whole fall short, asked after the last one; empty if they do not.
    std::function<QString(const Method &)> faultOfAll = {};
};

/// All checks, freshly created: none has seen a run. Some tables are kept in the folder for other
/// programs.
std::vector<RunCheck> runChecks(TableFolder &folder);

/// The parts of runChecks(), each defined in its own file.
std::vector<RunCheck> pictureChecks();
std::vector<RunCheck> recordChecks();
std::vector<RunCheck> wordChecks();
RunCheck formulaCheck();
RunCheck pseudocodeCheck();
RunCheck tableCheck(TableFolder &folder);
/// Fails if a fill rule, rounding, origin, pixel centre or arithmetic of the method is in no run
/// that writes a pixel.
RunCheck choiceCheck();

} // namespace pixelplumb
