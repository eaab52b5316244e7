// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stagevectors.h"

#include "core/space/stagenames.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// The most that fit on a line.
constexpr std::size_t mostSummands = 12;
constexpr std::size_t mostFanVertices = 4;

} // namespace

Component unitOf(const SpaceVector<double> &unit, const Component &component)
{
    if (unit.isZero())
        return [](QChar) { return u"0"_s; };
    return [component](QChar axis) {
        QStringList squares;
        for (const QChar each : spaceAxes)
            squares.append(component(each) + u'²');
        return component(axis) + u"/√("_s + squares.join(u" + "_s) + u')';
    };
}

QString crossFormula(const Component &a, const Component &b, QChar axis)
{
    const std::ptrdiff_t place = std::ranges::find(spaceAxes, axis) - spaceAxes.begin();
    const QChar next = spaceAxes[std::size_t(place + 1) % 3];
    const QChar last = spaceAxes[std::size_t(place + 2) % 3];
    return u"%1·%2 − %3·%4"_s.arg(a(next), b(last), a(last), b(next));
}

QString sumOverVertices(std::size_t count, const QString &number)
{
    if (count > mostSummands)
        return {};
    QStringList summands;
    for (std::size_t i = 0; i < count; ++i)
        summands.append(ofVertex(i, number));
    return summands.join(u" + "_s);
}

Component meanOverVertices(std::size_t count)
{
    return [count](QChar axis) {
        const QString sum = sumOverVertices(count, axis);
        return sum.isEmpty() ? sum : u"1/%1·(%2)"_s.arg(count).arg(sum);
    };
}

QString fanFormula(std::size_t count, QChar axis)
{
    if (count > mostFanVertices)
        return {};
    const auto side = [](std::size_t vertex) {
        return [vertex](QChar each) {
            return u"(%1 − %2)"_s.arg(ofVertex(vertex, each), ofVertex(0, each));
        };
    };
    QStringList products;
    for (std::size_t i = 2; i < count; ++i)
        products.append(crossFormula(side(i - 1), side(i), axis));
    return products.join(u" + "_s);
}

} // namespace pixelplumb
