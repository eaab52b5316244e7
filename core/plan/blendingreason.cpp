// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/effectreason.h"
#include "core/plan/sharededges.h"

namespace pixelplumb {

namespace {

/// Under the closed rule both triangles of a shared edge paint its samples, which shows where one
/// of them is transparent.
QString paintedTwiceWords(const Primitives &primitives, const NeedsTally &tally,
                          const SampledFrame &where)
{
    std::vector<const Triangle *> others;
    auto blended = tally.blended.begin(); // in drawing order
    for (const Triangle &triangle : primitives.triangles) {
        if (blended != tally.blended.end() && *blended == &triangle)
            ++blended;
        else
            others.push_back(&triangle);
    }
    const SharedSamples shared = sharedSamplesOf(tally.blended, others, where);
    if (shared.samples == 0)
        return {};
    return QStringLiteral("; the closed rule gives %1%2 on shared edges to both triangles, one of "
                          "them %3(%4, %5)")
        .arg(shared.isExact ? QString() : QStringLiteral("at most "))
        .arg(shared.samples == 1 ? QStringLiteral("1 sample")
                                 : QStringLiteral("%1 samples").arg(shared.samples))
        .arg(where.antialiasing == Antialiasing::None ? QString() : QStringLiteral("in pixel "))
        .arg(shared.first.x)
        .arg(shared.first.y);
}

} // namespace

QString blendingReason(const Primitives &primitives, const NeedsTally &tally,
                       const SampledFrame &where)
{
    const std::size_t blended = tally.of[Effect::Blending].primitives;
    if (blended == 0)
        return (tally.isOfAll() ? QStringLiteral("every alpha is 255: opaque")
                                : QStringLiteral("every alpha of a triangle%1 is 255: opaque")
                                      .arg(amongDrawn(tally)))
            + ofEnds(tally);
    const QString reason
        = QStringLiteral("%1 an alpha below 255, the lowest is %2")
              .arg(countedWords(blended, tally.drawnTriangles, "triangle", "has", "have"))
              .arg(tally.lowestAlpha)
        + ofEnds(tally);
    const bool sharesEdges = where.rule == FillRule::Closed
        && where.antialiasing != Antialiasing::Area && tally.drawnTriangles > 1;
    return sharesEdges ? reason + paintedTwiceWords(primitives, tally, where) : reason;
}

} // namespace pixelplumb
