// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationcolumns.h"

#include "core/methods/placecolumns.h"

#include <array>

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

const std::array<QString, channelCount> &channelNames()
{
    static const std::array<QString, channelCount> names
        = {QStringLiteral("R"),   QStringLiteral("G"),   QStringLiteral("B"),
           QStringLiteral("z"),   QStringLiteral("u"),   QStringLiteral("v"),
           QStringLiteral("N_x"), QStringLiteral("N_y"), QStringLiteral("N_z")};
    return names;
}

QString unitOf(std::size_t channel) { return channel < 3 ? QStringLiteral("levels") : QString(); }

/// "R_B", "N_xB".
QString withSubscript(const QString &name, const QString &subscript)
{
    return name.contains(u'_') ? name + subscript : name + u'_' + subscript;
}

/// "a_R", "a_Nx".
QString coefficientOf(const QString &coefficient, QString name)
{
    return coefficient + u'_' + name.remove(u'_');
}

const std::array coefficients = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")};
const std::array weightTitles = {QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")};
const std::array weightIds
    = {QStringLiteral("alpha"), QStringLiteral("beta"), QStringLiteral("gamma")};

TraceColumn compared(const QString &id, const QString &title, const QString &unit,
                     const QString &toolTip, const QString &formula, Group group)
{
    return {.id = id,
            .title = title,
            .unit = unit,
            .toolTip = toolTip,
            .formula = formula,
            .group = group,
            .comparison = Comparison::WithExact};
}

void appendWeights(std::vector<TraceColumn> &columns)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const QString &title = weightTitles[i];
        columns.push_back(
            compared(weightIds[i], title, {},
                     QStringLiteral("Weight of vertex %1: 1 there, 0 on the line through the other "
                                    "two.")
                         .arg(i),
                     QStringLiteral("%1 = a_%1·x + b_%1·y + c_%1").arg(title), Group::Decision));
    }
}

QString valueFormula(InterpolationForm form, const QString &name)
{
    switch (form) {
    case InterpolationForm::Bilinear:
        return QStringLiteral("%1 ← %1′ + Δ%1").arg(name);
    case InterpolationForm::Plane:
        return QStringLiteral("%1 = %2·x + %3·y + %4")
            .arg(name, coefficientOf(coefficients[0], name), coefficientOf(coefficients[1], name),
                 coefficientOf(coefficients[2], name));
    case InterpolationForm::Barycentric:
        // Not by arg(), which takes a subscript after a place-marker for one of its digits.
        return name + QStringLiteral(" = α·") + name + QStringLiteral("₀ + β·") + name
            + QStringLiteral("₁ + γ·") + name + u'₂';
    }
    return {};
}

} // namespace

std::vector<TraceColumn> interpolationSetUpColumns(InterpolationForm form)
{
    std::vector<TraceColumn> columns;
    if (form == InterpolationForm::Plane) {
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            for (const QString &coefficient : coefficients) {
                const QString title = coefficientOf(coefficient, channelNames()[channel]);
                columns.push_back(compared(
                    title, title, unitOf(channel),
                    QStringLiteral("Coefficient of the plane through the three values of %1: of "
                                   "x, of y, and alone.")
                        .arg(channelNames()[channel]),
                    {}, Group::ColourRates));
            }
        }
    }
    if (form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (const QString &coefficient : coefficients) {
                columns.push_back(compared(
                    coefficient + u'_' + weightIds[i], coefficient + u'_' + weightTitles[i], {},
                    QStringLiteral("Coefficient of the line through the other two "
                                   "vertices, scaled to 1 at vertex %1.")
                        .arg(i),
                    {}, Group::Decision));
            }
        }
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            for (std::size_t i = 0; i < 3; ++i) {
                const QString &name = channelNames()[channel];
                columns.push_back({.id = name + QString::number(i),
                                   .title = name + QChar(u'₀' + char16_t(i)),
                                   .unit = unitOf(channel),
                                   .toolTip = QStringLiteral("%1 at vertex %2.").arg(name).arg(i),
                                   .formula = {},
                                   .group = Group::EdgeColours});
            }
        }
    }
    return columns;
}

std::vector<TraceColumn> interpolationSpanColumns(InterpolationForm form)
{
    const auto px = QStringLiteral("px");
    std::vector<TraceColumn> columns = {
        triangleColumn(),
        scannedColumn(),
        halfColumn(),
        {.id = QStringLiteral("first_row"),
         .title = QStringLiteral("y_first"),
         .unit = px,
         .toolTip = QStringLiteral("The first covered row; exact in every arithmetic."),
         .formula = {},
         .group = Group::Span},
        {.id = QStringLiteral("last_row"),
         .title = QStringLiteral("y_last"),
         .unit = px,
         .toolTip = QStringLiteral("The last covered row; exact in every arithmetic."),
         .formula = {},
         .group = Group::Span},
        columnPixelsColumn(),
    };
    if (form != InterpolationForm::Bilinear)
        return columns;
    columns.push_back(compared(QStringLiteral("y_B"), QStringLiteral("y_B"), px,
                               QStringLiteral("Where the lower edge meets the column, as the "
                                              "channels use it."),
                               {}, Group::Span));
    columns.push_back(compared(QStringLiteral("y_T"), QStringLiteral("y_T"), px,
                               QStringLiteral("Where the upper edge meets the column, as the "
                                              "channels use it."),
                               {}, Group::Span));
    for (const bool isTop : {false, true}) {
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            const QString title = withSubscript(channelNames()[channel],
                                                isTop ? QStringLiteral("T") : QStringLiteral("B"));
            columns.push_back(compared(
                title, title, unitOf(channel),
                QStringLiteral("%1 where the %2 edge meets the column; its rate is added from "
                               "column to column.")
                    .arg(channelNames()[channel],
                         isTop ? QStringLiteral("upper") : QStringLiteral("lower")),
                {}, Group::EdgeColours));
        }
    }
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
        const QString &name = channelNames()[channel];
        columns.push_back(compared(QStringLiteral("delta_") + name, u'Δ' + name, unitOf(channel),
                                   QStringLiteral("Change of %1 for each upward move.").arg(name),
                                   QStringLiteral("Δ%1 = (%2 − %3)/(y_T − y_B)")
                                       .arg(name, withSubscript(name, QStringLiteral("T")),
                                            withSubscript(name, QStringLiteral("B"))),
                                   Group::ColourRates));
    }
    return columns;
}

std::vector<TraceColumn> interpolationSampleColumns(InterpolationForm form)
{
    std::vector<TraceColumn> columns;
    if (form == InterpolationForm::Barycentric)
        appendWeights(columns);
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
        const QString &name = channelNames()[channel];
        TraceColumn column
            = compared(name, name, unitOf(channel), QStringLiteral("%1 at the sample.").arg(name),
                       valueFormula(form, name), Group::FirstColour);
        if (form == InterpolationForm::Bilinear)
            column.startFormula = QStringLiteral("%1 ← %2 + (y − y_B)·Δ%1")
                                      .arg(name, withSubscript(name, QStringLiteral("B")));
        columns.push_back(column);
    }
    return columns;
}

} // namespace pixelplumb
