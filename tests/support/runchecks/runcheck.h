// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"
#include "core/runs/tracedscene.h"

#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace pixelplumb {

class TableFolder;

/// Why a run is among those that are checked.
enum class RunOrigin {
    Scene,
    Variant, ///< the method departs from the right algorithm
    HardCase,
};

/// A step of a run, explained.
struct ExplainedStep {
    TraceStep step;
    std::size_t index = 0;
    Explanation explanation;
};

/// A scene by a method in one arithmetic, traced once: what every check looks at.
struct CheckedRun {
    QString name; ///< "mixed, column-scan float32 closed truncate"
    RunOrigin origin = RunOrigin::Scene;
    std::shared_ptr<const TracedScene> traced;
    std::vector<ExplainedStep> steps; ///< some set-ups, spans and samples, ascending
};

/// What must hold of every run. It hears of the runs of one method, one after the other.
struct RunCheck {
    QString sentence; ///< "the picture is the truth where the method is stable"
    /// Why it does not hold of a run; empty where it does.
    std::function<QString(const CheckedRun &)> faultOf;
    /// Why the method's runs together fall short, when all have been seen; empty where they do not.
    std::function<QString(const Method &)> faultOfAll = {};
};

/// The checks, new: none has seen a run. Some tables are kept in the folder for other programs.
std::vector<RunCheck> runChecks(TableFolder &folder);

/// The same in parts, each in a file of its own.
std::vector<RunCheck> pictureChecks();
std::vector<RunCheck> recordChecks();
std::vector<RunCheck> wordChecks();
RunCheck formulaCheck();
RunCheck pseudocodeCheck();
RunCheck tableCheck(TableFolder &folder);
/// Fails where a fill rule, a rounding, an origin, a pixel centre or an arithmetic of the method is
/// in no run that writes a pixel.
RunCheck choiceCheck();

} // namespace pixelplumb
