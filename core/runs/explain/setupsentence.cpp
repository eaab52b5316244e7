// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/setupsentence.h"

#include "core/methods/words/formulatext.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t namedVertices = 8;

QString pointsText(const std::vector<Vertex> &vertices)
{
    QStringList points;
    for (std::size_t i = 0; i < std::min(vertices.size(), namedVertices); ++i)
        points.append(QStringLiteral("P%1 = %2")
                          .arg(QChar(char16_t(u'₀' + i)))
                          .arg(pointText(vertices[i].position)));
    if (vertices.size() > namedVertices)
        points.append(QStringLiteral("… %1 in all").arg(vertices.size()));
    return points.join(QStringLiteral(", ")) + u'.';
}

/// "Centre (32, 32), radius 7."
QString roundText(const Shape &shape)
{
    const LatticePoint &centre = shape.vertices[0].position;
    const LatticePoint &corner = shape.vertices[1].position;
    const QString text = QStringLiteral("Centre %1, ").arg(pointText(centre));
    const QString along = term(pixels(corner.x - centre.x));
    return shape.kind == PrimitiveKind::Circle ? text + QStringLiteral("radius %1.").arg(along)
                                               : text
            + QStringLiteral("radius %1 along x, %2 along y.")
                  .arg(along, term(pixels(corner.y - centre.y)));
}

/// Where a primitive is, in sample coordinates.
QString placeOfPrimitive(const TracedScene &traced, std::size_t primitive)
{
    if (traced.primitives.isTriangle(primitive)) {
        std::vector<Vertex> vertices;
        for (const int index : traced.trace->setUp(primitive).order)
            vertices.push_back(traced.primitives.triangles[primitive].vertices[std::size_t(index)]);
        return pointsText(vertices);
    }
    const Shape &shape = traced.primitives.shape(primitive);
    const bool isRound
        = shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse;
    return isRound ? roundText(shape) : pointsText(shape.vertices);
}

/// What a variant prints, and what it does.
QString variantText(Variant variant, SpanAxis axis)
{
    const VariantWords &words = wordsOf(variant, axis);
    return QStringLiteral(" Variant “%1”: %2, in place of %3. %4")
        .arg(nameText(words.title), nameText(words.printed), nameText(words.right),
             nameText(words.fault));
}

/// Which settings of the walk are not a right program's.
QString bugsText(const ScanBugs &bugs)
{
    QStringList ids;
    for (const ScanSetting &setting : scanSettings()) {
        if (valueOf(setting, bugs) != 0)
            ids += nameText(setting.id);
    }
    return ids.isEmpty() ? QString()
                         : QStringLiteral(" A program's mistakes are imitated, in: %1.")
                               .arg(ids.join(QStringLiteral(", ")));
}

} // namespace

QString setUpSentence(const TracedScene &traced, std::size_t primitive, const QString &words)
{
    QString sentence = words;
    if (words.isEmpty() || !traced.primitives.isTriangle(primitive))
        sentence = (placeOfPrimitive(traced, primitive) + u' ' + words).trimmed();
    for (const Variant variant : variantsIn(traced.scene.settings.variants))
        sentence += variantText(variant, traced.method->spanAxis);
    sentence += bugsText(traced.scene.settings.bugs);
    if (!traced.scene.settings.testBugs.isRight())
        sentence += QStringLiteral(" A program's mistakes are imitated in its edge tests.");
    if (traced.scene.frame.pixelCentre == PixelCentre::Half)
        sentence += QStringLiteral(" All coordinates are counted from the centre of pixel (0, 0): "
                                   "½ px less than the scene's.");
    return sentence;
}

} // namespace pixelplumb
