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
        points.append(
            u"P%1 = %2"_s.arg(QChar(char16_t(u'₀' + i))).arg(pointText(vertices[i].position)));
    if (vertices.size() > namedVertices)
        points.append(u"… %1 in all"_s.arg(vertices.size()));
    return points.join(u", "_s) + u'.';
}

/// "Centre (32, 32), radius 7."
QString roundText(const Shape &shape)
{
    const LatticePoint &centre = shape.vertices[0].position;
    const LatticePoint &corner = shape.vertices[1].position;
    const QString text = u"Centre %1, "_s.arg(pointText(centre));
    const QString along = term(pixels(corner.x - centre.x));
    return shape.kind == PrimitiveKind::Circle
        ? text + u"radius %1."_s.arg(along)
        : text + u"radius %1 along x, %2 along y."_s.arg(along, term(pixels(corner.y - centre.y)));
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
    return u" Variant “%1”: %2, in place of %3. %4"_s.arg(
        nameText(words.title), nameText(words.printed), nameText(words.right),
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
                         : u" A program's mistakes are imitated, in: %1."_s.arg(ids.join(u", "_s));
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
        sentence += u" A program's mistakes are imitated in its edge tests."_s;
    if (traced.scene.frame.pixelCentre == PixelCentre::Half)
        sentence += u" All coordinates are counted from the centre of pixel (0, 0): "
                    "½ px less than the scene's."_s;
    return sentence;
}

} // namespace pixelplumb
