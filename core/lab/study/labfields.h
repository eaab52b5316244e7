// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"
#include "core/scene/fields/jsonfields.h"

/// The names of a study's parts in files, also used to lay them out in columns.
namespace pixelplumb {

template <PartOf<Spread> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("lower", self.lower);
    visit("median", self.median);
    visit("upper", self.upper);
}

template <PartOf<LabShare> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("count", self.count);
    visit("of", self.of);
}

template <PartOf<LevelErrors> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("samples", self.samples);
    visit("max", self.largest);
    visit("rms", self.rms);
    visit("p99.9", self.p999);
}

template <PartOf<MissHistogram> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("missing", self.missing);
    visit("extra", self.extra);
}

template <PartOf<AccuracyFigures> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("triangles", self.triangles);
    visit("pixels", self.pixels);
    visit("missing", self.missing);
    visit("extra", self.extra);
    visit("tiesMissing", self.tiesMissing);
    visit("tiesExtra", self.tiesExtra);
    visit("wrongTriangles", self.wrongTriangles);
    visit("misses", self.misses);
    visit("farthestMissing", self.farthestMissing);
    visit("farthestExtra", self.farthestExtra);
    visit("wrongBytes", self.wrongBytes);
    visit("largestByteError", self.largestByteError);
    visit("levels", self.levels);
    visit("notANumber", self.notANumber);
    visit("infinite", self.infinite);
    visit("clamped", self.clamped);
    visit("gaps", self.gaps);
    visit("doubles", self.doubles);
    visit("flicker", self.flicker);
    visit("trueToggles", self.trueToggles);
    visit("orderFailures", self.orderFailures);
    visit("translationFailures", self.translationFailures);
}

template <PartOf<OperationCounts> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("stages", self.stages);
    visit("primitives", self.primitives);
    visit("spans", self.spans);
    visit("pixels", self.pixels);
    visit("refused", self.refused);
}

template <PartOf<CostFigures> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("perDraw", self.perDraw);
    visit("rounds", self.rounds);
    visit("straight", self.straight);
    visit("timesStraight", self.timesStraight);
    visit("operations", self.operations);
}

template <PartOf<CostFit> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("perTriangle", self.perTriangle);
    visit("perColumn", self.perColumn);
    visit("perPixel", self.perPixel);
    visit("residual", self.residual);
}

template <PartOf<ScanSettings> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("arithmetic", self.arithmetic);
    visit("fillRule", self.fillRule);
    visit("rounding", self.rounding);
}

template <PartOf<LabMiss> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("scene", self.scene);
    visit("x", self.x);
    visit("y", self.y);
}

template <PartOf<MachineConditions> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("processor", self.processor);
    visit("processors", self.processors);
    visit("caches", self.caches);
    visit("governor", self.governor);
    visit("system", self.system);
    visit("compiler", self.compiler);
    visit("flags", self.flags);
    visit("buildType", self.buildType);
    visit("sanitizers", self.sanitizers);
    visit("instructionSet", self.instructionSet);
    visit("load", self.load);
}

template <PartOf<EffectRow> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("group", self.group);
    visit("way", self.way);
    visit("arithmetic", self.arithmetic);
    visit("pixels", self.pixels);
    visit("nsPerPixel", self.perPixel);
    visit("timesFirst", self.timesFirst);
    visit("rms", self.rms);
    visit("wrongPixels", self.wrongPixels);
    visit("distance", self.distance);
    visit("brightness", self.brightness);
}

template <PartOf<StudyContender> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("id", self.id);
    visit("label", self.label);
    visit("kernel", self.kernel);
    visit("proved", self.isProved);
    visit("domain", self.domain);
    visit("fit", self.fit);
}

template <PartOf<StudyFamily> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("id", self.id);
    visit("title", self.title);
    visit("stresses", self.stresses);
    visit("triangles", self.triangles);
    visit("timedTriangles", self.timedTriangles);
    visit("timedPixels", self.timedPixels);
    visit("timedColumns", self.timedColumns);
    visit("timedRows", self.timedRows);
    visit("timedBytes", self.timedBytes);
    visit("digest", self.digest);
}

template <PartOf<LabRow> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("contender", self.contender);
    visit("family", self.family);
    visit("outcome", self.outcome);
    visit("remark", self.remark);
    visit("settings", self.settings);
    visit("accuracy", self.accuracy);
    visit("cost", self.cost);
    visit("firstMiss", self.firstMiss);
}

template <PartOf<Study> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("extent", self.extent);
    visit("seed", self.seed);
    visit("machine", self.conditions);
    visit("command", self.command);
    visit("contenders", self.contenders);
    visit("families", self.families);
    visit("rows", self.rows);
    visit("effects", self.effects);
    visit("rounds", self.rounds);
    visit("complete", self.isComplete);
}

template <>
struct FileWords<StudyExtent> {
    static constexpr std::array all = {StudyExtent::Quick, StudyExtent::Full};
};
template <>
struct FileWords<LabOutcome> {
    static constexpr std::array all
        = {LabOutcome::Pending, LabOutcome::Measured, LabOutcome::Refused, LabOutcome::TookTooLong,
           LabOutcome::Failed};
};
template <>
struct FileWords<LabKernel> {
    static constexpr const auto &all = allLabKernels;
};

} // namespace pixelplumb
