// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/grade/hunt/trial.h"
#include "core/number/jobprogress.h"
#include "core/runs/contender.h"

#include <optional>

namespace pixelplumb {

/// A scene, and the mistakes of a program that draws it.
struct DefectiveScene {
    Scene scene;
    std::vector<Defect> defects = {};
};

/// Something that draws pictures of scenes, to be compared with another.
struct PictureSource {
    QString name;
    std::function<Result<Picture>(const Scene &scene)> draw; ///< or says why it cannot
    /// The scene and defects that its run traces; none where it is no run of a method.
    std::function<std::optional<DefectiveScene>(const Scene &scene)> runOf = {};
    bool isStable = false; ///< its pictures are proved true
    bool isProgram = false; ///< each picture starts a process, so fewer are requested
};

PictureSource sourceOf(const Contender &contender);
/// Draws as `of` does, with the defect of this id; a scene to which it does not apply is drawn
/// right.
PictureSource sourceOf(const QString &defect, const Contender &of);
/// Draws what a program prints of the scene under the terms; their margin is ignored.
PictureSource sourceOf(const StudentProgram &student, const TrialTerms &terms = {});

/// A small scene of which two sources draw different pictures.
struct CounterExample {
    Scene scene;
    Picture one, other;
};

/// A scene that a source could not draw.
struct UndrawnScene {
    Scene scene;
    QString source; ///< its name
    InputError why;
};

struct CounterSearch {
    std::optional<CounterExample> found;
    std::int64_t tried = 0; ///< scenes, without those tried while shrinking
    std::int64_t compared = 0; ///< scenes of these that both drew
    std::int64_t undrawn = 0; ///< scenes that a side could not draw
    std::optional<UndrawnScene> firstUndrawn;
    bool wasEnded = false; ///< by the listener
};

/// Searches random scenes that grow from 3 px to 64, from whole coordinates to 1/256 px, from one
/// colour to several, and from one primitive to two that share an edge; an example found is shrunk
/// until no single step makes it simpler. The search ends early where the first hundred scenes
/// cannot be drawn. Primitives are lines where the conventions' method draws no triangles. Equal
/// seeds find the same. The listener hears how many scenes are tried, then, while shrinking, how
/// many simpler ones, of an unknown total; ending the shrinking keeps what was found.
CounterSearch findCounterExample(const PictureSource &one, const PictureSource &other,
                                 const Scene &conventions, std::uint64_t seed,
                                 const ProgressListener &listener = {});

/// What two sources draw of one scene, its frame fitted to the primitives.
enum class SceneOutcome {
    Same,
    Different,
    Undrawn, ///< by one of them
    Degenerate, ///< not tried: nothing has area or length
};
struct SceneTrial {
    SceneOutcome outcome = SceneOutcome::Same;
    std::optional<CounterExample> example; ///< where they differ
    std::optional<UndrawnScene> undrawn = {}; ///< where one of them cannot
};
SceneTrial tryScene(const PictureSource &one, const PictureSource &other, Scene scene);

/// Shrinks an example step by step: fewer primitives, a smaller frame, whole coordinates, smaller
/// ones, simpler colours.
CounterExample shrunk(CounterExample example, const PictureSource &one, const PictureSource &other,
                      const ProgressListener &listener = {});

} // namespace pixelplumb
