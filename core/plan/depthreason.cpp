// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/effectreason.h"

namespace pixelplumb {

namespace {

QString inQuestionWords(const DepthAnswer &answer)
{
    return QStringLiteral("; %1 triangles are in question").arg(answer.countInQuestion());
}

} // namespace

QString depthReason(const DepthAnswer &answer)
{
    using Ground = DepthAnswer::Ground;
    switch (answer.ground) {
    case Ground::FewTriangles:
        return QStringLiteral("no two triangles are drawn in the frame");
    case Ground::SameDepth:
        return QStringLiteral("all triangles that are drawn in the frame have the same depth");
    case Ground::InOrder:
        return QStringLiteral(
            "each triangle that is drawn in the frame is nearer than all before it, or as near");
    case Ground::Apart:
        return QStringLiteral("no two triangles that are drawn in the frame overlap");
    case Ground::NotBehind:
        return QStringLiteral(
            "where triangles overlap or touch, the later one is nearer or as near");
    case Ground::NoSample:
        return answer.antialiasing == Antialiasing::Area
            ? QStringLiteral("at the centre of every pixel in which two triangles are both drawn, "
                             "the later one is nearer or as near")
            : QStringLiteral("at every sample that two triangles cover, the later one is nearer "
                             "or as near");
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
