// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"
#include "core/grade/trial.h"
#include "core/number/jobprogress.h"
#include "core/runs/contender.h"

#include <optional>

namespace pixelplumb {

/// A scene, and what a program that draws it does wrong.
struct DefectiveScene {
    Scene scene;
    std::vector<Defect> defects = {};
};

/// Something that draws pictures of scenes, to be held against another.
struct PictureSource {
    QString name;
    std::function<Result<Picture>(const Scene &scene)> draw; ///< or why it cannot
    /// What its run is of; none where it is no run of a method.
    std::function<std::optional<DefectiveScene>(const Scene &scene)> runOf = {};
    bool isStable = false; ///< every picture is the truth, by proof
    bool isProgram = false; ///< each picture takes a start: fewer are asked for
};

PictureSource sourceOf(const Contender &contender);
/// What `of` draws with the defect, by its id; a scene that cannot have it is drawn right.
PictureSource sourceOf(const QString &defect, const Contender &of);
/// What a program prints of the scene, as the terms give it; their tolerance is not asked.
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
    std::int64_t tried = 0; ///< scenes, without those of the shrinking
    std::int64_t compared = 0; ///< of them, those that both drew
    std::int64_t undrawn = 0; ///< those that a side could not
    std::optional<UndrawnScene> firstUndrawn;
    bool wasEnded = false; ///< by the listener
};

/// Looks through random scenes that grow, from 3 px to 64, from whole coordinates to 1/256 px, of
/// one colour and then of several, with one primitive and then with two that share an edge; what
/// is found is shrunk until no single step makes it simpler. It ends early where the first hundred
/// that are asked for cannot be drawn. Primitives are lines where the conventions' method draws no
/// triangles. The same seed finds the same. The listener hears how many of the scenes are tried,
/// then, while it is shrunk, how many that are simpler, of a total that nobody knows; what it ends
/// then is found all the same.
CounterSearch findCounterExample(const PictureSource &one, const PictureSource &other,
                                 const Scene &conventions, std::uint64_t seed,
                                 const ProgressListener &listener = {});

/// What two draw of one scene, its frame fitted to the primitives.
enum class SceneOutcome {
    Same,
    Different,
    Undrawn, ///< by one of them
    Degenerate, ///< nothing has area or length: not asked
};
struct SceneTrial {
    SceneOutcome outcome = SceneOutcome::Same;
    std::optional<CounterExample> example; ///< where they differ
    std::optional<UndrawnScene> undrawn = {}; ///< where one of them cannot
};
SceneTrial tryScene(const PictureSource &one, const PictureSource &other, Scene scene);

/// The simplest one to which steps lead: fewer primitives, a smaller frame, whole coordinates,
/// smaller ones, simpler colours.
CounterExample shrunk(CounterExample example, const PictureSource &one, const PictureSource &other,
                      const ProgressListener &listener = {});

} // namespace pixelplumb
