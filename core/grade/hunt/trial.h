// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/tracediff.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/try/programrun.h"
#include "core/grade/try/studentoutput.h"

namespace pixelplumb {

/// What a student's program receives on stdin: a scene file, or plain lines (sceneLines).
enum class ProgramInput { Json, Lines };

/// The conditions of a trial.
struct TrialTerms {
    ProgramInput input = ProgramInput::Json;
    ProgramLimits limits;
    Margin margin; ///< of a right program
};

/// The result of one run of a student's program on one scene.
struct Trial {
    StudentRun run;
    std::optional<InputError> fault; ///< why its output is unusable; none where it is usable
    StudentOutput output;
    std::optional<PictureDiff> picture; ///< compared with what the scene's method draws
    std::optional<TraceDifference> trace; ///< where its lines first differ from the right ones

    /// Whether it printed something, but neither a picture nor a line with numbers.
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

/// "3 lines of its trace lie beyond the frame and are passed over"; none without such lines.
std::optional<QString> beyondFrameText(const StudentOutput &output);

/// Runs the program on the scene, under the terms; an error where the scene cannot be passed to it.
Result<StudentRun> runOn(const StudentProgram &student, const Scene &scene, const TrialTerms &terms,
                         const std::stop_token &stop = {});

/// Runs the program on a scene that its method can draw, and judges the output; an error where the
/// scene cannot be passed to it. Output is judged only if the program ended well; a whole picture
/// is judged also after another exit code than 0.
Result<Trial> tryProgram(const StudentProgram &student, const Scene &scene,
                         const TrialTerms &terms = {}, const std::stop_token &stop = {});

} // namespace pixelplumb
