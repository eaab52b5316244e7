// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"

#include "core/effects/requirements.h"
#include "core/effects/strokestrip.h"
#include "core/methods/barycentric.h"
#include "core/methods/columnscan.h"
#include "core/methods/constantraterowwalk.h"
#include "core/methods/curves.h"
#include "core/methods/edgeequations.h"
#include "core/methods/edgewalks.h"
#include "core/methods/interpolation.h"
#include "core/methods/lines.h"
#include "core/methods/polygons.h"
#include "core/methods/strokes.h"
#include "core/methods/text.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QString quoted(std::string_view name) { return u'“' + nameText(name) + u'”'; }

/// What a plan runs and not every method of triangles can.
std::vector<Effect> shadingEffectsOf(const EffectPlan &plan)
{
    std::vector<Effect> effects;
    for (const Effect effect : allEffects) {
        if (effect != Effect::SmoothColour && effect != Effect::Clipping && plan.runs(effect))
            effects.push_back(effect);
    }
    return effects;
}

/// Their ids.
template <class Draws>
QStringList methodsThatDo(const std::vector<Effect> &effects, const Draws &draws)
{
    QStringList ids;
    for (const Method &method : methods()) {
        const bool doesAll = std::ranges::all_of(
            effects, [&method](Effect effect) { return method.supports(effect); });
        if (doesAll && draws(method))
            ids.append(method.id);
    }
    return ids;
}

/// Who asks for it: the scene, or a person's switch alone.
QString askerText(bool isCalledFor)
{
    return isCalledFor ? QStringLiteral("which the scene calls for")
                       : QStringLiteral("which is forced on");
}
QString askerText(const EffectPlan &plan, const std::vector<Effect> &effects)
{
    return askerText(std::ranges::any_of(effects, [&plan](Effect effect) {
        return plan.verdicts[effect].verdict != Verdict::NotCalledFor;
    }));
}

QString lackText(const std::vector<Effect> &missing, const QString &asker, const QStringList &able)
{
    const QString separator = QStringLiteral(", ");
    return QStringLiteral("cannot do %1, %2; %3 can")
        .arg(namesOf(missing).join(separator), asker, able.join(separator));
}

} // namespace

QString spanRuleReason(SpanAxis axis)
{
    return QStringLiteral("a %1 ends at its two bounds whatever edge they belong to")
        .arg(axis == SpanAxis::Row ? QStringLiteral("row") : QStringLiteral("column"));
}

bool Method::drawInPieces(const Primitives &primitives, const ScanSettings &settings,
                          FrameView frame, const ProgressListener &listener) const
{
    const auto mayGoOn = [&](std::size_t done) {
        return goesOn(listener,
                      {JobPhase::Drawing, std::int64_t(done), std::int64_t(primitives.size())});
    };
    if (drawEffects) {
        if (const auto plan = planBeyondColour(primitives, settings, frame))
            return drawEffects(primitives, settings, frame, *plan, listener);
    }
    // Nothing but colour: no triangle depends on what those before it left.
    const std::span<const Triangle> triangles = primitives.triangles;
    for (std::size_t first = 0; first < triangles.size(); first += pieceSize()) {
        if (!mayGoOn(first))
            return false;
        const auto piece
            = triangles.subspan(first, std::min(pieceSize(), triangles.size() - first));
        drawFastest({{piece.begin(), piece.end()}, {}}, settings, frame);
    }
    for (std::size_t i = 0; i < primitives.shapes.size(); ++i) {
        if (!mayGoOn(triangles.size() + i))
            return false;
        drawFastest({{}, {primitives.shapes[i]}}, settings, frame);
    }
    return true;
}

bool Method::supports(Arithmetic arithmetic) const
{
    return std::ranges::find(arithmetics, arithmetic) != arithmetics.end();
}

bool Method::supports(FillRule rule) const
{
    return std::ranges::find(fillRules, rule) != fillRules.end();
}

bool Method::supports(Effect effect) const
{
    return std::ranges::find(effects, effect) != effects.end();
}

bool Method::draws(PrimitiveKind kind) const
{
    return std::ranges::find(kinds, kind) != kinds.end();
}

bool Method::draws(const Shape &shape) const
{
    return draws(shape.kind)
        && (fills.empty() || std::ranges::find(fills, shape.fill) != fills.end());
}

bool Method::isStableIn(Arithmetic arithmetic) const
{
    return std::ranges::find(stableArithmetics, arithmetic) != stableArithmetics.end();
}

QString Method::objection(const ScanSettings &settings) const
{
    if (!supports(settings.arithmetic))
        return QStringLiteral("does not compute in %1; it knows %2")
            .arg(quoted(nameOf(settings.arithmetic)),
                 namesOf(arithmetics).join(QStringLiteral(", ")));
    if (!supports(settings.fillRule))
        return QStringLiteral("cannot keep the fill rule %1: %2; it keeps %3")
            .arg(quoted(nameOf(settings.fillRule)), fillRuleReason,
                 namesOf(fillRules).join(QStringLiteral(", ")));
    return {};
}

QString Method::objection(const EffectPlan &plan, Arithmetic arithmetic) const
{
    if (plan.isPlain() || !draws(PrimitiveKind::Triangle))
        return {};
    const std::vector<Effect> run = shadingEffectsOf(plan);
    std::vector<Effect> missing = run;
    std::erase_if(missing, [this](Effect effect) { return supports(effect); });
    if (!missing.empty())
        return lackText(missing, askerText(plan, missing),
                        methodsThatDo(missing, [](const Method &method) {
                            return method.draws(PrimitiveKind::Triangle);
                        }));
    const QString separator = QStringLiteral(", ");
    if (!shadingArithmetics.empty()
        && std::ranges::find(shadingArithmetics, arithmetic) == shadingArithmetics.end())
        return QStringLiteral("cannot do %1, %2, in %3; it can in %4")
            .arg(namesOf(run).join(separator), askerText(plan, run), quoted(nameOf(arithmetic)),
                 namesOf(shadingArithmetics).join(separator));
    return {};
}

QString Method::objection(const Shape &shape, const Appearance &appearance) const
{
    if (antialiasingOf(appearance) == Antialiasing::None || !isStroke(shape) || !draws(shape)
        || supports(Effect::Antialiasing))
        return {};
    return lackText({Effect::Antialiasing},
                    askerText(appearance.antialiasing != Antialiasing::None),
                    methodsThatDo({Effect::Antialiasing},
                                  [&shape](const Method &method) { return method.draws(shape); }));
}

QString Method::refusal(const ScanSettings &settings) const
{
    const QString why = objection(settings);
    return why.isEmpty() ? why : QStringLiteral("method “%1” %2").arg(id, why);
}

ScanSettings Method::adapted(const ScanSettings &settings) const
{
    ScanSettings drawn = settings;
    if (!supports(drawn.arithmetic) && !arithmetics.empty())
        drawn.arithmetic = arithmetics.front();
    if (!supports(drawn.fillRule) && !fillRules.empty())
        drawn.fillRule = fillRules.front();
    return drawn;
}

QString titleOf(MethodFamily family)
{
    switch (family) {
    case MethodFamily::Triangles:
        return QStringLiteral("Triangles");
    case MethodFamily::StableForms:
        return QStringLiteral("Triangles, stable forms");
    case MethodFamily::Interpolation:
        return QStringLiteral("Interpolation");
    case MethodFamily::Lines:
        return QStringLiteral("Lines");
    case MethodFamily::Curves:
        return QStringLiteral("Curves");
    case MethodFamily::Polygons:
        return QStringLiteral("Polygons");
    case MethodFamily::Others:
        return QStringLiteral("Points and text");
    }
    return {};
}

std::span<const Method> methods()
{
    static const std::vector<Method> table = {
        columnScanMethod(),
        rowWalkMethod(),
        edgeEquationsMethod(),
        incrementalEdgeEquationsMethod(),
        solvedEdgeEquationsMethod(),
        allSamplesBarycentricMethod(),
        rectangleBarycentricMethod(),
        incrementalBarycentricMethod(),
        cramerBarycentricMethod(),
        offScreenBarycentricMethod(),
        biasColumnScanMethod(),
        constantRateColumnScanMethod(),
        constantRateRowWalkMethod(),
        canonicalEdgeEquationsMethod(),
        relativeBarycentricMethod(),
        bilinearInterpolationMethod(),
        planeInterpolationMethod(),
        barycentricInterpolationMethod(),
        lineDdaMethod(),
        lineSlopeInterceptMethod(),
        lineBresenhamMethod(),
        lineSymmetricMethod(),
        circleMidpointMethod(),
        circleExplicitMethod(),
        circleParametricMethod(),
        circleFillMethod(),
        bezierSubdivisionMethod(),
        strokeCoverageMethod(),
        polygonParityMethod(),
        polygonFanMethod(),
        polygonDelaunayMethod(),
        pointAddressMethod(),
        textOutlinesMethod(),
    };
    return table;
}

const Method *methodNamed(QStringView id)
{
    const auto found
        = std::ranges::find_if(methods(), [id](const Method &method) { return method.id == id; });
    return found != methods().end() ? &*found : nullptr;
}

const Method &firstMethodFor(PrimitiveKind kind)
{
    const auto found = std::ranges::find_if(
        methods(), [kind](const Method &method) { return method.draws(kind); });
    return found != methods().end() ? *found : methods().front();
}

const Method &firstMethodFor(const Shape &shape)
{
    const auto found = std::ranges::find_if(
        methods(), [&shape](const Method &method) { return method.draws(shape); });
    return found != methods().end() ? *found : methods().front();
}

const Method &firstMethodFor(const Shape &shape, const Appearance &appearance)
{
    const auto found = std::ranges::find_if(methods(), [&](const Method &method) {
        return method.draws(shape) && method.objection(shape, appearance).isEmpty();
    });
    return found != methods().end() ? *found : firstMethodFor(shape);
}

} // namespace pixelplumb
