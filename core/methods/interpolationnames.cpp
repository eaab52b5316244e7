// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationnames.h"

#include "core/methods/placenumbers.h"
#include "core/methods/units.h"

#include <array>

namespace pixelplumb {

const QString &channelName(std::size_t channel)
{
    static const std::array<QString, channelCount> names
        = {QStringLiteral("R"),   QStringLiteral("G"),   QStringLiteral("B"),
           QStringLiteral("z"),   QStringLiteral("u"),   QStringLiteral("v"),
           QStringLiteral("N_x"), QStringLiteral("N_y"), QStringLiteral("N_z")};
    return names[channel];
}

QString channelUnit(std::size_t channel, const QString &per)
{
    return channel < 3 ? unit::levels() + per : QString();
}

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
        half.toolTip = QStringLiteral("1: up to the middle vertex; 2: from there on.");
    return half;
}

NumberDescription comparedNumber(const QString &id, const QString &title, const QString &unit,
                                 const QString &toolTip, const QString &formula, NumberGroup group)
{
    return {.id = id,
            .title = title,
            .unit = unit,
            .toolTip = toolTip,
            .formula = formula,
            .group = group,
            .comparison = Comparison::WithExact};
}

} // namespace pixelplumb
