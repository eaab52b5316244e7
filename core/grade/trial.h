// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picturediff.h"
#include "core/grade/programrun.h"
#include "core/grade/studentoutput.h"
#include "core/grade/tracediff.h"

namespace pixelplumb {

/// What a student's program gets on stdin: a scene file, or plain lines (sceneLines).
enum class ProgramInput { Json, Lines };

/// How a trial is held.
struct TrialTerms {
    ProgramInput input = ProgramInput::Json;
    ProgramLimits limits;
    Arithmetic tolerance = Arithmetic::Float32; ///< what a right program may compute in; or exact
};

/// What became of one run of a student's program on one scene.
struct Trial {
    StudentRun run;
    std::optional<InputError> fault; ///< why its output is of no use; none where it is
    StudentOutput output;
    std::optional<PictureDiff> picture; ///< beside what the scene's method draws
    std::optional<TraceDifference> trace; ///< where its lines part from the right ones

    /// Whether it printed something, and neither a picture nor a line that has numbers.
    bool hasNothingToCompare() const
    {
        return run.end == ProgramEnd::Finished && !fault && !picture && !output.hasLines();
    }
    bool isRight() const
    {
        return run.end == ProgramEnd::Finished && !fault && !trace && !hasNothingToCompare()
            && (!picture || picture->differing() == 0);
    }
};

/// "3 lines of its trace lie beyond the frame and are passed over"; none where none does.
std::optional<QString> beyondFrameText(const StudentOutput &output);

/// Gives it the scene, as the terms say; an error where the scene cannot be given so.
Result<StudentRun> runOn(const StudentProgram &student, const Scene &scene, const TrialTerms &terms,
                         const std::stop_token &stop = {});

/// Runs it on the scene, which its method can draw, and judges what it printed; an error where the
/// scene cannot be given so. Output is looked at only where the program ended well, and a whole
/// picture also where it ended with another exit code than 0.
Result<Trial> tryProgram(const StudentProgram &student, const Scene &scene,
                         const TrialTerms &terms = {}, const std::stop_token &stop = {});

} // namespace pixelplumb
