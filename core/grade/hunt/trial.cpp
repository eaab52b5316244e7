// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/trial.h"

#include "core/grade/diagnose/undecidable.h"
#include "core/grade/try/scenelines.h"
#include "core/scene/scenefile.h"

namespace pixelplumb {

namespace {

/// The first difference in the whole lines printed before a bad end; the first wrong number often
/// explains it. Partial pictures are ignored.
std::optional<TraceDifference> differenceBeforeEnd(const QByteArray &output, const Scene &scene,
                                                   const Margin &margin)
{
    constexpr qsizetype longestRead = qsizetype(1) << 20; // bytes
    const QByteArray whole = output.left(longestRead);
    const QByteArray lines = whole.left(whole.lastIndexOf('\n') + 1);
    if (!looksLikeTrace(lines))
        return std::nullopt;
    const Result<StudentOutput> read = readStudentOutput(lines, scene);
    if (!read || !read->hasLines())
        return std::nullopt;
    const auto difference = traceDifferenceOf(scene, *read->trace, margin, TraceExtent::CutOff);
    return difference ? *difference : std::nullopt;
}

/// What it printed; none where that is not judged.
std::optional<Result<StudentOutput>> outputOf(const StudentRun &run, const Scene &scene)
{
    if (run.end != ProgramEnd::Finished && run.end != ProgramEnd::Failed)
        return std::nullopt;
    Result<StudentOutput> output = readStudentOutput(run.output, scene);
    // A failed program may still have written a whole picture.
    const bool isJudged
        = run.end == ProgramEnd::Finished || (output && output->picture && !output->trace);
    return isJudged ? std::optional(std::move(output)) : std::nullopt;
}

} // namespace

std::optional<QString> beyondFrameText(const StudentOutput &output)
{
    const std::int64_t lines = output.trace ? output.trace->beyondFrame : 0;
    if (lines == 0)
        return std::nullopt;
    return lines == 1
        ? u"1 line of its trace lies beyond the frame and is passed over"_s
        : u"%1 lines of its trace lie beyond the frame and are passed over"_s.arg(lines);
}

Result<StudentRun> runOn(const StudentProgram &student, const Scene &scene, const TrialTerms &terms,
                         const std::stop_token &stop)
{
    Scene drawn = scene;
    drawn.hidden.clear(); // not for the program
    std::erase_if(drawn.solids, [](const Solid &solid) { return solid.isHidden; });
    const Result<QByteArray> input
        = terms.input == ProgramInput::Json ? writeScene(drawn) : sceneLines(drawn);
    if (!input)
        return input.error();
    return runProgram(student, *input, terms.limits, stop);
}

Result<Trial> tryProgram(const StudentProgram &student, const Scene &scene, const TrialTerms &terms,
                         const std::stop_token &stop)
{
    Result<StudentRun> run = runOn(student, scene, terms, stop);
    if (!run)
        return run.error();
    Trial trial;
    trial.run = std::move(*run);
    const Scene judged = judgedScene(scene, terms.margin);
    std::optional<Result<StudentOutput>> read = outputOf(trial.run, scene);
    if (!read) {
        trial.fault = InputError{{}, trial.run.told, {}};
        trial.trace = differenceBeforeEnd(trial.run.output, judged, terms.margin);
        return trial;
    }
    Result<StudentOutput> &output = *read;
    if (!output) {
        trial.fault = output.error();
        return trial;
    }
    trial.output = std::move(*output);
    if (trial.output.picture) {
        const Picture right = pictureOf(judged);
        const Picture &found = *trial.output.picture;
        trial.picture
            = differenceOf(right, found, undecidablePixels(judged, right, found, terms.margin));
    }
    if (!trial.output.trace)
        return trial;
    Result<std::optional<TraceDifference>> difference
        = traceDifferenceOf(judged, *trial.output.trace, terms.margin);
    if (difference)
        trial.trace = std::move(*difference);
    else
        trial.fault = difference.error();
    return trial;
}

} // namespace pixelplumb
