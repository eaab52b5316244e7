// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/appearance.h"
#include "core/geometry/effect.h"
#include "core/methods/words/edgewalkform.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/scansettings.h"
#include "core/scan/tests/edgetestform.h"
#include "core/scan/variants.h"
#include "core/trace/stepwords.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// What a line says in a run with these variants.
struct VariedLine {
    VariantSet variants;
    QString text;
};

/// What a line says under a fill rule; an empty text leaves the line out.
struct RuledLine {
    FillRule rule = FillRule::Closed;
    QString text;
    std::optional<FrameOrigin> origin = {}; ///< only in frames whose y points that way
};

/// Which primitives execute a line: a triangle without area is drawn as its segment.
enum class LineOf { EveryPrimitive, Area, Segment };

/// A line of a method's pseudocode. What follows " — " explains it.
struct PseudocodeLine {
    int depth = 0; ///< of its indentation
    QString text; ///< in the symbols of the method's numbers
    std::vector<Moment> moments; ///< the steps that execute it; none if it only holds other lines
    std::optional<Effect> effect = {}; ///< the line exists only where this runs
    std::vector<VariedLine> varied = {}; ///< the last one whose variants the run has applies
    std::vector<RuledLine> ruled
        = {}; ///< that of the current rule applies; text is the closed one's
    std::vector<Antialiasing> antialiasing = {}; ///< it exists only under these; empty: under each
    LineOf of = LineOf::EveryPrimitive;
};
using Pseudocode = std::vector<PseudocodeLine>;

/// The lines as they read under a rule.
Pseudocode underRule(Pseudocode code, FillRule rule, FrameOrigin origin = FrameOrigin::BottomLeft);
/// Drops the lines of primitives of the other kind.
Pseudocode linesOf(LineOf kind, Pseudocode code);

/// For the families of methods that differ in a form.
Pseudocode edgeWalkPseudocode(const EdgeWalkForm &form);
Pseudocode edgeTestPseudocode(const EdgeTestForm &form);
Pseudocode interpolationPseudocode(InterpolationForm form);
/// With effects beyond colour, between exact bounds; the column scan's is in walklisting.h.
Pseudocode shadedPseudocode(InterpolationForm form);

} // namespace pixelplumb
