// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/hunt/trial.h"
#include "core/scene/scene.h"
#include "core/scene/text/result.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

/// The checks of a scene's picture; each is passed or not. Pixels that the assignment leaves open
/// count for neither side.
enum class Check {
    Picture, ///< the file exists, can be read and has the frame's size
    Coverage, ///< exactly what should be covered is covered
    Colours, ///< at least half of what should be covered is, always with the right bytes
    Invariants, ///< the program keeps what holds of every right picture (Invariant)
};
inline constexpr std::array allChecks
    = {Check::Picture, Check::Coverage, Check::Colours, Check::Invariants};
QString nameOf(Check check); ///< "picture", "coverage", "colours", "invariants"

/// How much a student is told; each level includes those before it.
enum class HintLevel {
    Class, ///< which checks were passed, and right, undecidable or wrong
    Hint, ///< where to look, by the defects that explain the pictures
    Pixels, ///< how many pixels of each kind, the first of them, the picture of differences
    Full, ///< what was done, and the first step that differs
};
inline constexpr std::array allHintLevels
    = {HintLevel::Class, HintLevel::Hint, HintLevel::Pixels, HintLevel::Full};
QString nameOf(HintLevel level); ///< "class", "hint", "pixels", "full"

/// How all triangles of the scenes wind, as seen on the screen; those without area do not.
enum class Winding { Any, CounterClockwise, Clockwise };
inline constexpr std::array allWindings
    = {Winding::Any, Winding::CounterClockwise, Winding::Clockwise};
QString nameOf(Winding winding); ///< "any", "counter-clockwise", "clockwise"
bool windsOtherwise(const Triangle &triangle, Winding winding, FrameOrigin origin);

/// By which convention of the frame a submission is judged.
enum class Convention {
    Asked, ///< the scenes' own
    Any, ///< that by which its pictures have the fewest wrong pixels (FrameConvention)
};
inline constexpr std::array allConventions = {Convention::Asked, Convention::Any};
QString nameOf(Convention convention); ///< "asked", "any"

/// What a failed check still earns.
enum class Credit {
    Whole, ///< nothing: all of its points or none
    Share, ///< for coverage and colours, the share of pixels that are right
};
inline constexpr std::array allCredits = {Credit::Whole, Credit::Share};
QString nameOf(Credit credit); ///< "whole", "share"

/// Points for each check, in the order of allChecks; 0: the check is not made.
using CheckPoints = std::array<double, allChecks.size()>;
inline constexpr double largestPoints = 1e6;

struct AssignedScene {
    QString name; ///< "shallow", for the picture file shallow.png; letters, digits, - and _
    Scene scene; ///< with the required conventions: method, fill rule, arithmetic …
    CheckPoints points = {1, 2, 2, 0};

    friend bool operator==(const AssignedScene &, const AssignedScene &) = default;
};

inline constexpr std::array allProgramInputs = {ProgramInput::Json, ProgramInput::Lines};
QString nameOf(ProgramInput input); ///< "json", "lines"

/// How programs are run, once for each scene.
struct AssignedProgram {
    QString file; ///< in the submission's folder: "rasterize"; empty: its only executable file
    ProgramInput input = ProgramInput::Json;
    int seconds = 10; ///< 1 … 3600
    int megabytes = 1024; ///< of memory, leastMegabytes … mostMegabytes
    int outputMegabytes = 64; ///< 1 … 1024

    friend bool operator==(const AssignedProgram &, const AssignedProgram &) = default;
};

/// What a class was asked to draw, and how it is judged.
struct Assignment {
    QString name; ///< "Assignment 2: column scan"
    std::vector<AssignedScene> scenes; ///< at least one; their names differ
    HintLevel hint = HintLevel::Hint;
    Margin margin;
    Winding winding = Winding::Any; ///< that is promised to programs
    Convention convention = Convention::Asked;
    Credit credit = Credit::Whole;
    std::optional<AssignedProgram> program; ///< none: only pictures are graded, nothing is run

    double points() const;

    friend bool operator==(const Assignment &, const Assignment &) = default;
};

/// The format of the JSON that writeAssignment() writes, and the newest that readAssignment()
/// reads.
inline constexpr int assignmentFormat = 1;

/// Scenes are part of the file, or files named relative to the folder; empty: the current one.
/// Scenes that their method cannot draw are errors.
Result<Assignment> readAssignment(const QByteArray &text, const QString &folder = {});
Result<Assignment> readAssignmentFile(const QString &path);

/// The assignment to draw one scene, the task "task", with the points of a scene that has none of
/// its own; as it would be read from a file, so that a scene that its method cannot draw is an
/// error.
Result<Assignment> assignmentOf(const Scene &scene, const QString &name);

/// What a JSON file says that it is, whether or not the rest of it can be read; Other for one that
/// is too long to be read at once, beside the user's hand.
enum class FileKind { Scene, Assignment, Other };
FileKind kindOfFile(const QString &path);

/// Writes it whole, with its scenes: equal assignments give equal bytes.
QByteArray writeAssignment(const Assignment &assignment);

} // namespace pixelplumb
