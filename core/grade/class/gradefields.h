// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"
#include "core/scene/fields/jsonfields.h"

namespace pixelplumb {

// The names in files of the fields of a submission's grade.

template <PartOf<GradedCheck> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("check", self.check);
    visit("passed", self.isPassed);
    visit("points", self.points);
    visit("of", self.of);
}

template <PartOf<GradedRun> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("end", self.end);
    visit("told", self.told);
    visit("messages", self.messages);
    visit("sandboxLack", self.sandboxLack);
}

template <PartOf<FramePixel> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("x", self.x);
    visit("y", self.y);
}

template <PartOf<GradedScene> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("scene", self.scene);
    visit("file", self.file);
    visit("fault", self.fault);
    visit("lack", self.lack);
    visit("picture", self.picture);
    visit("pictureDigest", self.pictureDigest);
    visit("counts", self.counts.pixels); // same, missing, extra, colour, undecidable
    visit("largestError", self.largestError);
    visit("causes", self.causes);
    visit("firstDifference", self.firstDifference);
    visit("run", self.run);
    visit("trace", self.trace);
    visit("note", self.note);
    visit("checks", self.checks);
    visit("brokenInvariants", self.brokenInvariants);
    visit("explanations", self.explanations);
    visit("places", self.places);
}

/// The names of all submissions, graded or not.
struct SubmissionList {
    QStringList submissions;
};
template <PartOf<SubmissionList> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("submissions", self.submissions);
}

template <PartOf<FirstDivergence> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("scene", self.scene);
    visit("step", self.step);
    visit("heading", self.heading);
    visit("text", self.text);
}

template <PartOf<GradedCandidate> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("defects", self.defects);
    visit("student", self.forStudent);
    visit("assistant", self.forAssistant);
    visit("distance", self.distance);
    visit("undecidable", self.undecidable);
    visit("arithmetic", self.arithmetic);
    visit("parts", self.parts);
    visit("rightAlone", self.rightAlone);
}

template <PartOf<GradeReview> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("comment", self.comment);
    visit("accepted", self.isAccepted);
    visit("points", self.points);
    visit("reason", self.reason);
}

template <PartOf<GradedSubmission> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("name", self.name);
    visit("id", self.id);
    visit("digest", self.digest);
    visit("verdict", self.verdict);
    visit("convention", self.convention);
    visit("differing", self.differing);
    visit("scenes", self.scenes);
    visit("candidates", self.candidates);
    visit("pictures", self.pictures);
    visit("searchError", self.searchError);
    visit("gradingError", self.gradingError);
}

template <>
struct FileWords<Check> {
    static constexpr const auto &all = allChecks;
};
template <>
struct FileWords<FrameConvention> {
    static constexpr const auto &all = allFrameConventions;
};
template <>
struct FileWords<PictureLack> {
    static constexpr const auto &all = allPictureLacks;
};
template <>
struct FileWords<GradeVerdict> {
    static constexpr const auto &all = allGradeVerdicts;
};

} // namespace pixelplumb
