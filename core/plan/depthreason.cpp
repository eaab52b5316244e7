// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/effectreason.h"

namespace pixelplumb {

namespace {

/// How many triangles are seen to need depth, and how many more were not ruled out.
QString inQuestionWords(const DepthAnswer &answer)
{
    const std::size_t more = answer.countInQuestion() - answer.shown;
    if (answer.shown == 0)
        return QStringLiteral("; %1 triangles may be in question").arg(more);
    const QString shown = QStringLiteral("; %1 triangles are in question").arg(answer.shown);
    return more == 0 ? shown : shown + QStringLiteral(", and %1 more may be").arg(more);
}

} // namespace

QString depthReason(const DepthAnswer &answer, const SampledFrame &where)
{
    using Ground = DepthAnswer::Ground;
    const bool isByArea = where.antialiasing == Antialiasing::Area;
    const QString byCentres = "in every pixel where two triangles are drawn, the later one is at "
                              "least as near at the pixel's centre";
    switch (answer.ground) {
    case Ground::FewTriangles:
        return QStringLiteral("fewer than two triangles are drawn in the frame");
    case Ground::SameDepth:
        return QStringLiteral("all triangles drawn in the frame have the same depth");
    case Ground::InOrder:
        return QStringLiteral("each triangle drawn in the frame is at least as near as all before "
                              "it");
    case Ground::Apart:
        return QStringLiteral("the triangles drawn in the frame do not overlap");
    case Ground::NotBehind:
        if (isByArea)
            return byCentres;
        return where.rule == FillRule::Closed // the others give no sample to both that touch there
            ? QStringLiteral("where triangles overlap or touch, the later one is at least as near")
            : QStringLiteral("where triangles overlap, the later one is at least as near");
    case Ground::NoSample:
        return isByArea
            ? byCentres
            : QStringLiteral("at every sample that two triangles cover, the later one is at least "
                             "as near");
    case Ground::Witness:
        return QStringLiteral("at pixel (%1, %2) triangle %3 lies behind triangle %4, which is "
                              "drawn before it")
                   .arg(answer.place.x)
                   .arg(answer.place.y)
                   .arg(answer.later)
                   .arg(answer.earlier)
            + inQuestionWords(answer);
    case Ground::NoWitness:
        return QStringLiteral("triangle %1 may lie behind triangle %2, which is drawn before it; "
                              "it does not at the samples that were checked")
                   .arg(answer.later)
                   .arg(answer.earlier)
            + inQuestionWords(answer);
    case Ground::TooMany:
        return QStringLiteral("too many triangles lie close together to compare them all")
            + inQuestionWords(answer);
    }
    return {};
}

} // namespace pixelplumb
