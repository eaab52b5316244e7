// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationnames.h"
#include "core/methods/shadednumbers.h"

#include <array>
#include <functional>

namespace pixelplumb {

namespace {

constexpr std::array coefficientLetters = {u'a', u'b', u'c'};

/// The digits of the ends of the segment that represents a triangle without area.
struct SegmentDigits {
    explicit SegmentDigits(const ShadedSetUpState &state)
        : first(vertexDigits[std::size_t(state.order[0])])
        , last(vertexDigits[std::size_t(state.order[2])])
    {
        const LatticePoint &from = state.position[std::size_t(state.order[0])];
        const LatticePoint &to = state.position[std::size_t(state.order[2])];
        if (from != to)
            along = from.x == to.x ? u'y' : u'x';
    }
    /// Whether a coefficient multiplies the coordinate that it is measured along.
    bool isAlong(QChar coefficient) const
    {
        return !along.isNull() && (coefficient == u'a') == (along == u'x');
    }
    /// Fills in # and & for the ends, @ for the coordinate.
    QString filled(QString text) const
    {
        return text.replace(u'#', first).replace(u'&', last).replace(u'@', along);
    }

    QChar first, last;
    QChar along; ///< x or y; null where the segment is a point
};

/// a, b or c of the plane through the vertices' values %, or of the segment's line.
QString planeFormula(const ShadedSetUpState &state, QChar letter, const QString &name)
{
    const auto coefficient = [&](QChar other) { return coefficientOf(other, name); };
    QString text;
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        if (letter == u'c')
            text = ends.along.isNull() ? ends.filled(QStringLiteral("%#"))
                                       : ends.filled(QStringLiteral("%# − ")
                                                     + coefficient(ends.along == u'x' ? u'a' : u'b')
                                                     + QStringLiteral("·@#"));
        else
            text = ends.isAlong(letter) ? ends.filled(QStringLiteral("(%& − %#)/(@& − @#)"))
                                        : QStringLiteral("0");
    } else if (letter != u'c') {
        text = planeSlope(letter == u'a' ? u'x' : u'y');
    } else {
        text = QStringLiteral("%₀ − %1·x₀ − %2·y₀").arg(coefficient(u'a'), coefficient(u'b'));
    }
    return coefficient(letter) + QStringLiteral(" = ") + text.replace(u'%', name);
}

/// a, b or c of the weight of a vertex: 1 there, 0 on the line through the other two.
QString weightFormula(const ShadedSetUpState &state, QChar letter, std::size_t vertex)
{
    const QString weight = weightTitle(vertex);
    const auto coefficient = [&](QChar other) { return coefficientOf(other, weight); };
    const QString left = coefficient(letter) + QStringLiteral(" = ");
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        const bool isFirst = std::size_t(state.order[0]) == vertex;
        const bool isLast = std::size_t(state.order[2]) == vertex;
        if (letter != u'c')
            return left
                + (!ends.isAlong(letter) || !(isFirst || isLast)
                       ? QStringLiteral("0")
                       : ends.filled(isLast ? QStringLiteral("1/(@& − @#)")
                                            : QStringLiteral("−1/(@& − @#)")));
        if (ends.along.isNull() || !(isFirst || isLast))
            return left + (isFirst ? QStringLiteral("1") : QStringLiteral("0"));
        return left
            + ends.filled((isFirst ? QStringLiteral("1 − ") : QStringLiteral("−"))
                          + coefficient(ends.along == u'x' ? u'a' : u'b') + QStringLiteral("·@#"));
    }
    const auto filled = [&](QString text) {
        return text.replace(u'#', vertexDigits[(vertex + 1) % 3])
            .replace(u'&', vertexDigits[(vertex + 2) % 3])
            .replace(u'@', vertexDigits[vertex]);
    };
    const QString there = QStringLiteral("((y& − y#)·(x@ − x#) + (x# − x&)·(y@ − y#))");
    if (letter == u'c')
        return left
            + filled(QStringLiteral("−") + coefficient(u'a') + QStringLiteral("·x# − ")
                     + coefficient(u'b') + QStringLiteral("·y#"));
    return left
        + filled((letter == u'a' ? QStringLiteral("(y& − y#)/") : QStringLiteral("(x# − x&)/"))
                 + there);
}

/// a, b and c of a value or of a weight.
struct Coefficients {
    QString name; ///< of the value or weight
    QString unit; ///< its unit
    QString toolTip;
    std::function<Quantity(const ShadedSetUpState &, std::size_t)> read;
    std::function<QString(const ShadedSetUpState &, QChar)> formula;
};

void appendCoefficients(NumberTable<ShadedSetUpState> &table, const Coefficients &of)
{
    for (std::size_t k = 0; k < coefficientLetters.size(); ++k) {
        const QChar letter = coefficientLetters[k];
        const QString title = coefficientOf(letter, of.name);
        table.push_back(
            {comparedNumber(title, title,
                            k < 2 && !of.unit.isEmpty() ? of.unit + QStringLiteral("/px") : of.unit,
                            of.toolTip, {}, NumberGroup::ColourRates),
             [read = of.read, k](const ShadedSetUpState &state) { return read(state, k); },
             [formula = of.formula, letter](NumberDescription &number,
                                            const ShadedSetUpState &state) {
                 number.formula = formula(state, letter);
             }});
    }
}

} // namespace

void appendPlanes(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    if (scope.form == InterpolationForm::Plane)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            const QString name = linearName(channelAt(channel), scope.effects);
            appendCoefficients(
                table,
                {name, unitOf(channelAt(channel)),
                 QStringLiteral("Of %1 = a·x + b·y + c over the triangle.").arg(name),
                 [channel](const ShadedSetUpState &state, std::size_t k) {
                     return state.plane[channel][k];
                 },
                 [name](const ShadedSetUpState &state, QChar letter) {
                     return planeFormula(state, letter, name);
                 }});
        });
    if (scope.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            appendCoefficients(
                table,
                {weightTitle(i),
                 {},
                 QStringLiteral("Of the weight of P%1, a·x + b·y + c.").arg(vertexDigits[i]),
                 [i](const ShadedSetUpState &state, std::size_t k) { return state.weight[i][k]; },
                 [i](const ShadedSetUpState &state, QChar letter) {
                     return weightFormula(state, letter, i);
                 }});
    }
}

} // namespace pixelplumb
