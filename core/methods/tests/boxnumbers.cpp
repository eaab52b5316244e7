// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/boxnumbers.h"

#include "core/methods/tests/edgetestnames.h"
#include "core/methods/words/placenumbers.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// "⌈x_least⌉", or as the slides round it; `half` is their ½ with its sign.
QString rounded(const QString &exactly, const QString &corner, BoxRounding rounding,
                const QString &half)
{
    switch (rounding) {
    case BoxRounding::None:
        break;
    case BoxRounding::IntegerCentres:
        return u"(int)(%1 %2)"_s.arg(corner, half);
    case BoxRounding::HalfCentres:
        return u"(int)(%1 + ½ %2)"_s.arg(corner, half);
    }
    return exactly.arg(corner);
}

/// Clips a sample to the frame by min or max.
QString clipped(const QString &sample, const char *function, std::optional<std::int64_t> border)
{
    return border ? u"%1(%2, %3)"_s.arg(QLatin1String(function), sample,
                                        QString::number(*border).replace(u'-', u'−'))
                  : sample;
}

/// x_least or the like: `choice` is min or max.
NumberRow<EdgeTestSetUpState> cornerRow(const EdgeTestNames &names, QChar axis, const char *choice)
{
    const bool isLeast = QLatin1String(choice) == QLatin1String("min");
    const QString title = axis + (isLeast ? u"_least"_s : u"_greatest"_s);
    QStringList of;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        of.append(axis + names.vertex(vertex));
    return {plainNumber(title, title, "px",
                        u"The %1 %2 of the vertices: a side of their box."_s
                            .arg(isLeast ? u"least"_s : u"greatest"_s)
                            .arg(axis),
                        u"%1 = %2(%3, %2(%4, %5))"_s.arg(title, QLatin1String(choice), of[0], of[1],
                                                         of[2])),
            // The box is made of the vertices' lattice units, in every arithmetic.
            [axis, isLeast](const EdgeTestSetUpState &state) {
                std::array<Lattice, 3> units;
                std::ranges::transform(state.vertices, units.begin(), [axis](const Vertex &vertex) {
                    return axis == u'x' ? vertex.position.x : vertex.position.y;
                });
                return Quantity::rational(
                    isLeast ? std::ranges::min(units) : std::ranges::max(units), unitsPerPixel);
            }};
}

} // namespace

QString firstInBoxFormula(QChar axis, const BoxExtent &extent)
{
    const QString sample = rounded("⌈%1⌉", axis + u"_least"_s, extent.rounding, "+ ½");
    return axis + u"_min = "_s + clipped(sample, "max", extent.firstClip());
}

QString lastInBoxFormula(QChar axis, const BoxExtent &extent)
{
    const QString sample = rounded("⌊%1⌋", axis + u"_greatest"_s, extent.rounding, "− ½");
    return axis + u"_max = "_s + clipped(sample, "min", extent.lastClip());
}

void appendBox(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names)
{
    const EdgeTestForm &form = names.form();
    if (form.visited == VisitedSamples::Frame)
        return;
    for (const QChar axis : {u'x', u'y'}) {
        table.push_back(cornerRow(names, axis, "min"));
        table.push_back(cornerRow(names, axis, "max"));
    }
    // The samples along the loops are numbers of each span.
    const bool isRow = form.order == LoopOrder::RowByRow;
    appendExtent(table, form, isRow ? u'y' : u'x', isRow ? u"row"_s : u"column"_s,
                 NumberGroup::Position);
}

} // namespace pixelplumb
