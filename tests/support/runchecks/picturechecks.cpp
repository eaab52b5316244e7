// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/tracecursor.h"
#include "tests/support/runchecks/runcheck.h"

#include <QImage>

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

/// The first pixel, row by row from the top, at which two pictures differ; empty if none does.
QString differenceBetween(const QImage &is, const QImage &should)
{
    for (int row = 0; row < should.height(); ++row) {
        for (int column = 0; column < should.width(); ++column) {
            if (is.pixel(column, row) != should.pixel(column, row))
                return u"column %1, row %2 of the picture is #%3, not #%4"_s.arg(column)
                    .arg(row)
                    .arg(is.pixel(column, row), 8, 16, QChar(u'0'))
                    .arg(should.pixel(column, row), 8, 16, QChar(u'0'));
        }
    }
    return {};
}

QString replayFault(const CheckedRun &run)
{
    const TracedScene &traced = *run.traced;
    const FrameBuffer drawn(traced.scene.frame);
    drawScene(traced.scene, drawn);
    TraceCursor cursor(*traced.trace, traced.scene.frame);
    const QImage start = cursor.frame().copy();
    cursor.seek(traced.trace->stepCount());
    const QString atTheEnd = differenceBetween(cursor.frame().copy(), drawn.copy());
    if (!atTheEnd.isEmpty())
        return u"at the end "_s + atTheEnd;
    cursor.seek(traced.trace->stepCount() / 2);
    TraceCursor direct(*traced.trace, traced.scene.frame);
    direct.seek(traced.trace->stepCount() / 2);
    const QString halfWay = differenceBetween(cursor.frame().copy(), direct.frame().copy());
    if (!halfWay.isEmpty())
        return u"half-way back "_s + halfWay;
    cursor.seek(0);
    const QString atTheStart = differenceBetween(cursor.frame().copy(), start);
    return atTheStart.isEmpty() ? QString() : u"back at the start "_s + atTheStart;
}

/// Whether the method refuses, with a reason, to draw a primitive: then its picture is incomplete.
bool refusesSome(const ScanTrace &trace)
{
    return std::ranges::any_of(trace.rejectedPrimitives(), [&trace](std::size_t primitive) {
        const auto rejection = trace.setUp(primitive).rejection;
        return !(rejection == PrimitiveRejection::OutsideFrame)
            && !(rejection == PrimitiveRejection::ZeroArea)
            && !(rejection == PrimitiveRejection::NotOfThisMethod);
    });
}

QString truthFault(const CheckedRun &run)
{
    const TracedScene &traced = *run.traced;
    // With effects, square roots are not decided exactly everywhere.
    if (traced.shading() || !traced.method->isStableUnder(traced.scene.settings)
        || refusesSome(*traced.trace) || traced.differences.total() == 0)
        return {};
    return u"%1 pixels missing, %2 extra, %3 in another colour"_s
        .arg(traced.differences.count(Difference::Missing))
        .arg(traced.differences.count(Difference::Extra))
        .arg(traced.differences.count(Difference::Colour));
}

/// For each pixel that differs from the truth, the position after the last visit that decides it.
std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> lastVisitsOf(const TracedScene &traced)
{
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> visits;
    const ScanTrace &trace = *traced.trace;
    for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
        const PixelChange &change = trace.changes()[sample];
        const Difference kind = traced.differences.at(change.x, change.y);
        if (kind == Difference::Missing || (kind != Difference::None && change.isWritten()))
            visits[{change.x, change.y}] = trace.indexOfSample(sample) + 1;
    }
    return visits;
}

QString decidedFault(const CheckedRun &run)
{
    const TracedScene &traced = *run.traced;
    if (traced.shading())
        return {};
    const auto mark = std::ranges::find(traced.marks, MarkKind::FirstDifference, &TraceMark::kind);
    if (traced.differences.total() == 0)
        return mark == traced.marks.end() ? QString() : u"a mark, and no pixel differs"_s;
    const auto visits = lastVisitsOf(traced);
    std::size_t first = traced.trace->stepCount() + 1;
    const FrameView view = traced.truth.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            const Difference kind = traced.differences.at(x, y);
            if (kind == Difference::None)
                continue;
            const auto visit = visits.find({x, y});
            const std::size_t decided = traced.decidedAt(x, y);
            first = std::min(first, decided);
            if (visit == visits.end() ? kind != Difference::Missing : decided != visit->second)
                return u"(%1, %2) is decided at %3"_s.arg(x).arg(y).arg(decided);
        }
    }
    if (traced.firstWrongPixel()->decidedAt != first)
        return u"the first wrong pixel is decided at %1, not at %2"_s
            .arg(traced.firstWrongPixel()->decidedAt)
            .arg(first);
    return mark != traced.marks.end() && mark->step + 1 == first
        ? QString()
        : u"the mark does not stand before position %1"_s.arg(first);
}

QString levelFault(const CheckedRun &run)
{
    const TracedScene &traced = *run.traced;
    const ScanTrace &trace = *traced.trace;
    if (traced.shading() || !traced.method->draws(PrimitiveKind::Triangle))
        return {};
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const std::vector<SampleRecord> samples = trace.samples(span);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const PixelChange &change = trace.changes()[trace.firstSampleOf(span) + i];
            const Colour bytes = unpacked(change.after);
            for (std::size_t channel = 0; channel < 3 && change.isWritten(); ++channel) {
                if (std::clamp<std::int64_t>(samples[i].level[channel], 0, 255)
                    != bytes.channels[channel])
                    return u"at (%1, %2) the level %3 is the byte %4"_s.arg(change.x)
                        .arg(change.y)
                        .arg(samples[i].level[channel])
                        .arg(bytes.channels[channel]);
            }
        }
    }
    return {};
}

} // namespace

std::vector<RunCheck> pictureChecks()
{
    return {{u"tracing changes no pixel, and every position can be reached from "
             "either side"_s,
             replayFault},
            {u"the picture is the truth where the method is stable"_s, truthFault},
            {u"a wrong pixel is decided by its last visit"_s, decidedFault},
            {u"the levels of a sample are the bytes of its pixel"_s, levelFault}};
}

} // namespace pixelplumb
