// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/edgename.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QChar subscript(std::ptrdiff_t number) { return QChar(char16_t(u'₀' + number)); }

std::ptrdiff_t rankOf(const SetUpRecord &setUp, int vertex)
{
    return std::ranges::find(setUp.order, vertex) - setUp.order.begin();
}

} // namespace

QString vertexName(const SetUpRecord &setUp, int vertex)
{
    return u'P' + QString(subscript(rankOf(setUp, vertex)));
}

QString edgeName(const SetUpRecord &setUp, int from, int to)
{
    if (!setUp.longEdge)
        return vertexName(setUp, from) + vertexName(setUp, to);
    const auto [first, last] = std::minmax({rankOf(setUp, from), rankOf(setUp, to)});
    return u"L%1%2"_s.arg(subscript(first)).arg(subscript(last));
}

} // namespace pixelplumb
