// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"

#include "core/methods/words/placenumbers.h"

#include <array>

namespace pixelplumb {

QString withSubscript(const QString &name, const QString &subscript)
{
    return name.contains(u'_') ? name + subscript : name + u'_' + subscript;
}

QString coefficientOf(const QString &coefficient, QString name)
{
    return coefficient + u'_' + name.remove(u'_');
}

QString weightTitle(std::size_t vertex) { return QChar(char16_t(u'α' + vertex)); }

QString weightId(std::size_t vertex)
{
    constexpr std::array ids = {"alpha", "beta", "gamma"};
    return QString::fromLatin1(ids[vertex]);
}

EdgeWalkNames walkNames(InterpolationForm form)
{
    return EdgeWalkNames(EdgeWalkForm{axisOf(form), WalkForm::Accumulated, ColourRate::Bilinear});
}

NumberDescription halfNumberOf(InterpolationForm form)
{
    NumberDescription half = halfNumber();
    if (!isBilinear(form))
        half.toolTip = "1: up to the middle vertex; 2: from there on.";
    return half;
}

} // namespace pixelplumb
