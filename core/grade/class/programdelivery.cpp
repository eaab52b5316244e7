// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/programdelivery.h"

#include "core/grade/hunt/allowance.h"
#include "core/grade/hunt/trial.h"
#include "core/grade/showntext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Why content has no usable picture.
PictureLack lackIn(const QByteArray &content, const FrameSpec &frame)
{
    if (content.isEmpty())
        return PictureLack::Empty;
    return isOfOtherSize(content, frame) ? PictureLack::OtherSize : PictureLack::Unreadable;
}

/// A program that waits or keeps starting processes does so in each scene: full limits apply once.
ProgramLimits limitsAfter(const std::vector<Delivery> &deliveries)
{
    ProgramLimits limits;
    const auto isAny = [&](bool Delivery::*is) { return std::ranges::any_of(deliveries, is); };
    if (isAny(&Delivery::exceededTotalCpuTime))
        limits.timesInAll = limits.clockTimes = 1;
    if (isAny(&Delivery::hasWaited))
        limits.clockTimes = 1;
    return limits;
}

void addNote(const QString &note, Delivery &delivery)
{
    delivery.note = delivery.note ? *delivery.note + u"; "_s + note : note;
}

/// Notes that it had less time than others, if it was late again.
void noteOnTime(const ProgramLimits &limits, Delivery &delivery)
{
    const ProgramLimits whole;
    if (delivery.exceededTotalCpuTime && limits.timesInAll < whole.timesInAll)
        addNote(u"its processes were given less time together, for they had computed "
                "too long in a scene before"_s,
                delivery);
    else if (delivery.hasWaited && limits.clockTimes < whole.clockTimes)
        addNote(u"it was given less time by the clock, for it had been ended in a "
                "scene before"_s,
                delivery);
}

/// A program that relies on a winding is asked for triangles of that winding alone.
PictureSource windingAs(Winding winding, const PictureSource &source)
{
    return {source.name,
            [winding, draw = source.draw](Scene scene) {
                for (Triangle &triangle : scene.triangles) {
                    if (windsOtherwise(triangle, winding, scene.frame.origin))
                        std::swap(triangle.vertices[1], triangle.vertices[2]);
                }
                return draw(scene);
            },
            {},
            source.isStable,
            source.isProgram};
}

/// Has the program draw a few random pairs of triangles under the scene's conventions. Another fill
/// rule or rounding than ours breaks nothing, unless the leeway is strict.
void askForInvariants(const StudentProgram &student, const TrialTerms &terms,
                      const AssignedRun &asked, Delivery &delivery)
{
    constexpr int pairs = 8;
    constexpr std::uint64_t seed = 1;
    const Margin &margin = asked.assignment.margin;
    const PictureSource source = sourceOf(student, terms);
    const PictureSource judged
        = margin.isStrict() ? source : allowingFor({Leeway::Edges, margin.tolerance}, source);
    const InvariantReport report = checkInvariants(windingAs(asked.assignment.winding, judged),
                                                   asked.scene.scene, seed, pairs);
    if (report.undrawn > 0)
        addNote(u"of the %1 pairs of random triangles that invariants ask for it did "
                "not draw %2: %3"_s.arg(report.checked + report.undrawn)
                    .arg(report.undrawn)
                    .arg(shownText(report.firstUndrawn->why.message().toUtf8())),
                delivery);
    if (report.undrawn > 0 && report.broken.empty())
        return;
    delivery.brokenInvariants.emplace();
    for (const BrokenInvariant &broken : report.broken) {
        delivery.brokenInvariants->push_back(broken.invariant);
        addNote(u"broken: "_s + sentenceOf(broken.invariant), delivery);
    }
}

} // namespace

bool isScript(const SubmittedFile &file) { return !file.isExecutable && file.name.endsWith(".py"); }

void refuse(Delivery &delivery, PictureLack lack, const QString &fault)
{
    delivery.lack = lack;
    delivery.fault = fault;
}

void take(const QByteArray &content, const Result<StudentOutput> &output, const FrameSpec &frame,
          Delivery &delivery)
{
    if (!output)
        refuse(delivery, lackIn(content, frame), shownText(output.error().message().toUtf8()));
    else if (output->picture)
        delivery.picture = output->picture;
    else
        refuse(delivery, PictureLack::TraceAlone, u"there is no picture in it"_s);
}

Delivery drawnBy(const AssignedRun &asked, const std::vector<Delivery> &before,
                 const std::stop_token &stop)
{
    const auto &[entry, file, assignment, scene] = asked;
    Delivery delivery;
    const std::optional<QString> path = entry.pathOf(file);
    if (!path) {
        refuse(delivery, PictureLack::NotDrawn, u"the program's name is no UTF-8"_s);
        return delivery;
    }
    // Next to a submission that is a single file lie other submissions.
    const auto student = studentProgramOf(
        isScript(file) ? QStringList{scriptInterpreter(), *path} : QStringList{*path},
        entry.isFolder() ? ShownFiles::WithFolders : ShownFiles::Alone);
    if (!student) {
        refuse(delivery, PictureLack::NotDrawn, student.error().found);
        return delivery;
    }
    const AssignedProgram &program = *assignment.program;
    TrialTerms terms;
    terms.margin = assignment.margin;
    terms.input = program.input;
    terms.limits = limitsAfter(before);
    const ProgramLimits limits = terms.limits;
    terms.limits.time = std::chrono::seconds(program.seconds);
    terms.limits.memory = std::int64_t(program.megabytes) << 20;
    terms.limits.output = std::int64_t(program.outputMegabytes) << 20;
    const Result<Trial> trial = tryProgram(*student, scene.scene, terms, stop);
    if (!trial) {
        refuse(delivery, PictureLack::NotDrawn, trial.error().message());
        return delivery;
    }
    delivery.run = GradedRun{nameOf(trial->run.end), shownText(trial->run.told.toUtf8()),
                             shownText(trial->run.messages)};
    if (!trial->run.isSandboxed())
        delivery.run->sandboxLack = trial->run.sandboxLack;
    delivery.hasWaited = trial->run.isByClock;
    delivery.exceededTotalCpuTime = trial->run.isInAll;
    if (trial->trace)
        delivery.trace = shownText(trial->trace->text.toUtf8());
    delivery.note = beyondFrameText(trial->output);
    const bool isJudged = trial->output.picture.has_value();
    if (isJudged && trial->run.end == ProgramEnd::Failed)
        delivery.note = shownText(trial->run.told.toUtf8())
            + u"; the picture that it wrote is judged all the same"_s;
    if (trial->run.end != ProgramEnd::Finished && !isJudged)
        refuse(delivery, PictureLack::NotDrawn, shownText(trial->fault->message().toUtf8()));
    else if (trial->fault)
        take(trial->run.output, *trial->fault, scene.scene.frame, delivery);
    else
        take(trial->run.output, trial->output, scene.scene.frame, delivery);
    if (delivery.picture && scene.points[std::size_t(Check::Invariants)] > 0)
        askForInvariants(*student, terms, asked, delivery);
    noteOnTime(limits, delivery);
    return delivery;
}

} // namespace pixelplumb
