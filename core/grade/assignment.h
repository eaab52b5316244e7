// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/trial.h"
#include "core/scene/result.h"
#include "core/scene/scene.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

/// What is asked of the picture of a scene; each is passed or not. Pixels that the assignment
/// leaves open count for neither.
enum class Check {
    Picture, ///< it is there, can be read and has the frame's size
    Coverage, ///< what is to be covered is, nothing else is
    Colours, ///< at least half of what is to be covered is, and wherever it is with the right bytes
};
inline constexpr std::array allChecks = {Check::Picture, Check::Coverage, Check::Colours};
QString nameOf(Check check); ///< "picture", "coverage", "colours"

/// How much a student is told; each tells what those before tell, too.
enum class HintLevel {
    Class, ///< which checks were passed, and right, undecidable or wrong
    Hint, ///< where to look, by the defects that explain the pictures
    Pixels, ///< how many pixels of which kind, the first of them, the picture of differences
    Full, ///< what was done, and the first step that parts
};
inline constexpr std::array allHintLevels
    = {HintLevel::Class, HintLevel::Hint, HintLevel::Pixels, HintLevel::Full};
QString nameOf(HintLevel level); ///< "class", "hint", "pixels", "full"

/// Which pixels may be either way.
enum class Leeway {
    None, ///< the scene's fill rule decides all
    Edges, ///< those whose sample lies on an edge, where rules differ
    Float32, ///< and those that a right program may get otherwise that computes in it
    Float64,
};
inline constexpr std::array allLeeways
    = {Leeway::None, Leeway::Edges, Leeway::Float32, Leeway::Float64};
QString nameOf(Leeway leeway); ///< "none", "edges", "float32", "float64"
/// What a right program may compute in; exact where it has to have the exact numbers.
Arithmetic toleranceOf(Leeway leeway);

/// What a check that is not passed gives.
enum class Credit {
    Whole, ///< nothing: all of its points or none
    Share, ///< of coverage and of colours the share of the pixels that are right
};
inline constexpr std::array allCredits = {Credit::Whole, Credit::Share};
QString nameOf(Credit credit); ///< "whole", "share"

/// Points of each check, in the order of allChecks; 0: it is not asked.
using CheckPoints = std::array<double, allChecks.size()>;
inline constexpr double largestPoints = 1e6;

struct AssignedScene {
    QString name; ///< "shallow": of the picture's file, shallow.png; letters, digits, - and _
    Scene scene; ///< with the conventions asked for: method, fill rule, arithmetic …
    CheckPoints points = {1, 2, 2};

    friend bool operator==(const AssignedScene &, const AssignedScene &) = default;
};

inline constexpr std::array allProgramInputs = {ProgramInput::Json, ProgramInput::Lines};
QString nameOf(ProgramInput input); ///< "json", "lines"

/// How programs are run, once for each scene.
struct AssignedProgram {
    QString file; ///< in the submission's folder: "rasterize"; empty: its one executable file
    ProgramInput input = ProgramInput::Json;
    int seconds = 10; ///< 1 … 3600
    int megabytes = 1024; ///< of memory, leastMegabytes … mostMegabytes
    int outputMegabytes = 64; ///< 1 … 1024

    friend bool operator==(const AssignedProgram &, const AssignedProgram &) = default;
};

/// What a class was asked to draw, and how it is judged.
struct Assignment {
    QString name; ///< "Assignment 2: column scan"
    std::vector<AssignedScene> scenes; ///< one at least; their names differ
    HintLevel hint = HintLevel::Hint;
    Leeway leeway = Leeway::Float32;
    Credit credit = Credit::Whole;
    std::optional<AssignedProgram> program; ///< none: pictures alone are graded, nothing is run

    double points() const;

    friend bool operator==(const Assignment &, const Assignment &) = default;
};

/// Of the JSON that writeAssignment() writes, and the newest that readAssignment() reads.
inline constexpr int assignmentFormat = 1;

/// Scenes stand in the file, or are named as seen from the folder; empty: the current one. Scenes
/// that their method cannot draw are errors.
Result<Assignment> readAssignment(const QByteArray &text, const QString &folder = {});
Result<Assignment> readAssignmentFile(const QString &path);

/// Whole, with its scenes: the same assignment, the same bytes.
QByteArray writeAssignment(const Assignment &assignment);

} // namespace pixelplumb
