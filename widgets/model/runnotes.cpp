// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/runnotes.h"

#include "core/methods/method.h"
#include "core/methods/words/rejectiontext.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

struct RunNotes {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::RunNotes)
};

struct PlacingHint {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PlacingHint)
};

QString invitation(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return PlacingHint::tr("Click three points on the canvas to draw a triangle");
    case PrimitiveKind::Point:
        return PlacingHint::tr("Click to draw a point");
    case PrimitiveKind::Line:
        return PlacingHint::tr("Click two points to draw a line");
    case PrimitiveKind::Circle:
        return PlacingHint::tr("Click the centre and a corner of the square around the circle; "
                               "Primitives ▸ Form makes it an ellipse");
    case PrimitiveKind::Ellipse:
        return PlacingHint::tr("Click the centre and a corner of the box around the ellipse");
    case PrimitiveKind::Bezier:
        return PlacingHint::tr("Click four control points to draw a curve");
    case PrimitiveKind::Polygon:
        return PlacingHint::tr("Click the corners of a polygon, then its first corner again");
    case PrimitiveKind::Text:
        return PlacingHint::tr("Click where the text begins");
    }
    return {};
}

QString pluralOf(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return PlacingHint::tr("triangles");
    case PrimitiveKind::Point:
        return PlacingHint::tr("points");
    case PrimitiveKind::Line:
        return PlacingHint::tr("lines");
    case PrimitiveKind::Circle:
        return PlacingHint::tr("circles");
    case PrimitiveKind::Ellipse:
        return PlacingHint::tr("ellipses");
    case PrimitiveKind::Bezier:
        return PlacingHint::tr("curves");
    case PrimitiveKind::Polygon:
        return PlacingHint::tr("polygons");
    case PrimitiveKind::Text:
        return PlacingHint::tr("texts");
    }
    return {};
}

/// What a method draws: "outlined circles and ellipses".
QString drawnBy(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds += pluralOf(kind);
    const QString names = kinds.join(PlacingHint::tr(" and "));
    if (method.fills.empty())
        return names;
    const bool outlines = std::ranges::find(method.fills, ShapeFill::Outline) != method.fills.end();
    return (outlines ? PlacingHint::tr("outlined %1") : PlacingHint::tr("filled %1")).arg(names);
}

bool drawsAny(const Method &method, const Scene &scene)
{
    return (scene.hasTriangles() && method.draws(PrimitiveKind::Triangle))
        || std::ranges::any_of(scene.shapes,
                               [&](const Shape &shape) { return method.draws(shape); });
}

} // namespace

QString snapNote(const SnapReports &snaps)
{
    constexpr std::size_t mostLines = 3;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(snaps.size(), mostLines); ++i)
        lines += snaps[i].message();
    if (snaps.size() > mostLines)
        lines += RunNotes::tr("and %n more numbers are taken as the nearest of 1/256 px or 2^-24",
                              nullptr, int(snaps.size() - mostLines));
    return lines.join(u'\n');
}

QString rejectionNote(const TracedScene &traced)
{
    if (!foreignSceneHint(traced.scene).isEmpty())
        return {};
    std::vector<RejectedPrimitive> rejected = rejectedPrimitives(traced);
    std::erase_if(rejected, [](const RejectedPrimitive &each) {
        return each.rejection == PrimitiveRejection::OutsideFrame
            || each.rejection == PrimitiveRejection::BetweenSamples;
    });
    if (rejected.empty())
        return {};
    const RejectedPrimitive &first = rejected.front();
    const QString kind = coreWord(nameOf(first.kind));
    const QString text
        = u"%1 %2: %3"_s.arg(kind.left(1).toUpper() + kind.sliced(1),
                             QString::number(first.primitive), rejectionText(first.rejection));
    return rejected.size() == 1 ? text
                                : RunNotes::tr("%L1 primitives are not drawn. The first: %2")
                                      .arg(rejected.size())
                                      .arg(text);
}

QString adaptationNote(const Method &method, const ScanSettings &asked)
{
    const ScanSettings drawn = method.adapted(asked);
    QStringList objections;
    QStringList changes;
    ScanSettings settings = asked; // an objection names the first obstacle
    if (drawn.arithmetic != asked.arithmetic) {
        objections += method.objection(settings);
        changes += RunNotes::tr("the arithmetic %1").arg(nameText(nameOf(drawn.arithmetic)));
        settings.arithmetic = drawn.arithmetic;
    }
    if (drawn.fillRule != asked.fillRule) {
        objections += method.objection(settings);
        changes += RunNotes::tr("the fill rule %1").arg(nameText(nameOf(drawn.fillRule)));
        settings.fillRule = drawn.fillRule;
    }
    if (drawn.variants != asked.variants) {
        objections += method.objection(settings);
        changes += RunNotes::tr("what it knows of the variants");
    }
    if (changes.empty())
        return {};
    return RunNotes::tr("%1 %2. Changed to %3.")
        .arg(methodTitle(method), withTitles(objections.join(RunNotes::tr(", and "))),
             changes.join(RunNotes::tr(" and ")));
}

QString withTitles(const QString &text)
{
    static const QRegularExpression id(QStringLiteral(R"((?<![\w-])[a-z]+(-[a-z]+)+(?![\w-]))"));
    QString shown;
    qsizetype end = 0;
    for (const QRegularExpressionMatch &match : id.globalMatch(text)) {
        const Method *method = methodNamed(match.captured());
        shown += text.mid(end, match.capturedStart() - end)
            + (method ? u'“' + methodTitle(*method) + u'”' : match.captured());
        end = match.capturedEnd();
    }
    return shown + text.mid(end);
}

QString objectionNote(const Method &method, const QString &objection)
{
    return u"%1 %2."_s.arg(methodTitle(method), withTitles(objection));
}

QString verdictNote(const TracedScene &traced)
{
    const std::int64_t wrong = traced.differences.total();
    if (traced.trace->isCut() || (wrong == 0 && traced.trace->writtenCount() == 0))
        return {};
    const QString verdict = wrong == 0
        ? RunNotes::tr("When finished: all pixels correct")
        : RunNotes::tr("When finished: %1 px wrong; the exact picture has %2 px")
              .arg(wrong)
              .arg(traced.truePixels);
    return traced.scene.appearance.forced == EffectForcing{}
        ? verdict
        : RunNotes::tr("as forced: %1").arg(verdict);
}

QString cutRunNote(const TracedScene &traced)
{
    return RunNotes::tr(
               "Only the first %L1 steps are recorded, into primitive %L2 of %L3: stepping and the "
               "panels end there. At the end the canvas shows the finished picture. To record the "
               "whole run, make the frame or the scene smaller.")
        .arg(traced.trace->stepCount())
        .arg(traced.trace->primitiveCount())
        .arg(traced.primitives.size());
}

QString cancelledRunNote()
{
    return RunNotes::tr(
        "Tracing was cancelled: the panels show the run before. Undo the change, or change the "
        "scene again to trace it.");
}

QString foreignSceneHint(const Scene &scene)
{
    if (scene.isEmpty() && scene.hiddenCount() > 0)
        return PlacingHint::tr("All primitives are hidden: Edit ▸ Show all hidden primitives.");
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    if (!method || scene.isEmpty() || drawsAny(*method, scene))
        return {};
    const Method &other = scene.hasTriangles()
        ? firstMethodFor(PrimitiveKind::Triangle)
        : firstMethodFor(scene.shapes.front(), scene.appearance);
    return PlacingHint::tr("%1 draws %2; this scene has none. %3 draws what is here.")
        .arg(methodTitle(*method), drawnBy(*method), methodTitle(other));
}

QString emptyRunText(const TracedScene *traced)
{
    if (!traced)
        return PlacingHint::tr("The run is still being recorded. Its numbers appear here.");
    const QString foreign = foreignSceneHint(traced->scene);
    if (!foreign.isEmpty())
        return foreign;
    if (traced->primitives.size() == 0)
        return PlacingHint::tr("%1. Every number of every step appears here.")
            .arg(invitation(traced->method->kinds.front()));
    return PlacingHint::tr("The method drew nothing of this scene.");
}

QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content)
{
    if (pendingVertices == 0)
        return content == FrameContent::Empty ? invitation(kind) : QString();
    if (kind == PrimitiveKind::Circle || kind == PrimitiveKind::Ellipse)
        return PlacingHint::tr("Click the corner of the box around it");
    if (kind == PrimitiveKind::Polygon && pendingVertices >= 3)
        return PlacingHint::tr("Click the next corner, or the first one to close the polygon");
    switch (pendingVertices) {
    case 1:
        return PlacingHint::tr("Click the second point");
    case 2:
        return PlacingHint::tr("Click the third point");
    case 3:
        return PlacingHint::tr("Click the fourth point");
    default:
        break;
    }
    return PlacingHint::tr("Click the next point");
}

} // namespace pixelplumb
