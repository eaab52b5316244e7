// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalkcolumns.h"

#include "core/methods/channelcolumns.h"
#include "core/methods/placecolumns.h"

#include <array>

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

/// The letters by axis. {a} runs along the span and {c} across the spans; {lo} and {hi} are its
/// bounds: B and T of a column, L and R of a row. {way} is the way from where an edge starts.
struct WalkNames {
    explicit WalkNames(const EdgeWalkTable &of)
        : table(of)
    {
    }

    QString filled(QString text) const
    {
        const bool isRow = table.axis == SpanAxis::Row;
        text.replace(QStringLiteral("{way lo}"),
                     isRow ? QStringLiteral("(y_v{lo} − y)") : QStringLiteral("(x − x_v{lo})"));
        text.replace(QStringLiteral("{way hi}"),
                     isRow ? QStringLiteral("(y_v{hi} − y)") : QStringLiteral("(x − x_v{hi})"));
        text.replace(QStringLiteral("{a}"), isRow ? QStringLiteral("x") : QStringLiteral("y"));
        text.replace(QStringLiteral("{c}"), isRow ? QStringLiteral("y") : QStringLiteral("x"));
        text.replace(QStringLiteral("{lo}"), isRow ? QStringLiteral("L") : QStringLiteral("B"));
        text.replace(QStringLiteral("{hi}"), isRow ? QStringLiteral("R") : QStringLiteral("T"));
        text.replace(QStringLiteral("{span}"),
                     isRow ? QStringLiteral("row") : QStringLiteral("column"));
        text.replace(QStringLiteral("{part}"),
                     isRow ? QStringLiteral("trapezoid") : QStringLiteral("half"));
        text.replace(QStringLiteral("{lower}"),
                     isRow ? QStringLiteral("left") : QStringLiteral("lower"));
        return text.replace(QStringLiteral("{upper}"),
                            isRow ? QStringLiteral("right") : QStringLiteral("upper"));
    }

    /// One column, or with % in its texts one for each channel.
    void append(std::vector<TraceColumn> &columns, const TraceColumn &pattern) const
    {
        TraceColumn column = pattern;
        for (QString *text : {&column.id, &column.title, &column.unit, &column.toolTip,
                              &column.formula, &column.startFormula})
            *text = filled(*text);
        if (column.title.contains(u'%'))
            appendChannels(columns, column);
        else
            columns.push_back(column);
    }

    EdgeWalkTable table;
};

QString text(const char16_t *utf16) { return QString::fromUtf16(utf16); }

TraceColumn column(const char16_t *title, const char16_t *unit, const char16_t *toolTip,
                   const char16_t *formula, Group group, Comparison comparison = Comparison::None)
{
    TraceColumn column;
    column.id = text(title).replace(u'Δ', QStringLiteral("delta_"));
    column.id.replace(u'δ', QStringLiteral("rate_")).replace(u'β', QStringLiteral("bias"));
    column.id.replace(u' ', u'_');
    column.title = text(title);
    column.unit = text(unit);
    column.toolTip = text(toolTip);
    column.formula = text(formula);
    column.group = group;
    column.comparison = comparison;
    return column;
}

TraceColumn startingWith(TraceColumn column, const char16_t *startFormula)
{
    column.startFormula = text(startFormula);
    return column;
}

/// Position and colour of both bounds.
void appendBounds(std::vector<TraceColumn> &columns, const WalkNames &names)
{
    const bool isDirect = names.table.form == WalkForm::Direct;
    const auto exact = Comparison::WithExact;
    const char16_t *lower = u"{a}_{lo} ← {a}_v{lo} + {way lo}·m_{lo}";
    const char16_t *upper = u"{a}_{hi} ← {a}_v{hi} + {way hi}·m_{hi}";
    names.append(
        columns,
        startingWith(column(u"{a}_{lo}", u"px", u"Where the {lower} edge meets the {span}.",
                            isDirect ? lower : u"{a}_{lo} ← {a}_{lo}′ + m_{lo}", Group::Span,
                            exact),
                     isDirect ? u"" : lower));
    names.append(
        columns,
        startingWith(column(u"{a}_{hi}", u"px", u"Where the {upper} edge meets the {span}.",
                            isDirect ? upper : u"{a}_{hi} ← {a}_{hi}′ + m_{hi}", Group::Span,
                            exact),
                     isDirect ? u"" : upper));
}

void appendEdges(std::vector<TraceColumn> &columns, const WalkNames &names)
{
    const auto add = [&](const char16_t *title, const char16_t *unit, const char16_t *toolTip) {
        names.append(columns, column(title, unit, toolTip, u"", Group::EdgeColours));
    };
    add(u"m_{lo}", u"px/{span}", u"What a step to the next {span} adds to the {lower} bound.");
    add(u"{c}_v{lo}", u"px",
        u"Where the {lower} edge comes from: its vertex or the {span} before.");
    add(u"{a}_v{lo}", u"px",
        u"Where the {lower} edge comes from: its vertex or the {span} before.");
    add(u"m_{hi}", u"px/{span}", u"What a step to the next {span} adds to the {upper} bound.");
    add(u"{c}_v{hi}", u"px",
        u"Where the {upper} edge comes from: its vertex or the {span} before.");
    add(u"{a}_v{hi}", u"px",
        u"Where the {upper} edge comes from: its vertex or the {span} before.");
    if (names.table.form == WalkForm::Direct) {
        add(u"β_{lo}", u"px",
            u"Half the distance between the values that the bound can have; 0 "
            u"where the edge is computed in integers.");
        add(u"β_{hi}", u"px",
            u"Half the distance between the values that the bound can have; 0 "
            u"where the edge is computed in integers.");
    }
}

void appendColours(std::vector<TraceColumn> &columns, const WalkNames &names)
{
    const bool isDirect = names.table.form == WalkForm::Direct;
    const bool isPlane = names.table.rate == ColourRate::Plane;
    const auto exact = Comparison::WithExact;
    const char16_t *lower = u"%_{lo} ← %_v{lo} + {way lo}·δ%_{lo}";
    const char16_t *upper = u"%_{hi} ← %_v{hi} + {way hi}·δ%_{hi}";
    names.append(columns,
                 startingWith(column(u"%_{lo}", u"levels",
                                     u"Level of % where the {lower} edge meets the {span}.",
                                     isDirect ? lower : u"%_{lo} ← %_{lo}′ + δ%_{lo}",
                                     Group::EdgeColours, exact),
                              isDirect ? u"" : lower));
    names.append(columns,
                 startingWith(column(u"%_{hi}", u"levels",
                                     u"Level of % where the {upper} edge meets the {span}.",
                                     isDirect ? upper : u"%_{hi} ← %_{hi}′ + δ%_{hi}",
                                     Group::EdgeColours, exact),
                              isDirect ? u"" : upper));
    names.append(columns,
                 column(u"%_v{lo}", u"levels", u"Level of % where the {lower} edge comes from.",
                        u"", Group::EdgeColours));
    names.append(columns,
                 column(u"%_v{hi}", u"levels", u"Level of % where the {upper} edge comes from.",
                        u"", Group::EdgeColours));
    names.append(columns,
                 column(u"δ%_{lo}", u"levels/{span}",
                        u"What a step to the next {span} adds to %_{lo}.", u"",
                        Group::ColourRates));
    names.append(columns,
                 column(u"δ%_{hi}", u"levels/{span}",
                        u"What a step to the next {span} adds to %_{hi}.", u"",
                        Group::ColourRates));
    names.append(columns,
                 column(u"Δ%", u"levels/px",
                        isPlane ? u"Change of % for each step along the {span}, the same in all."
                                : u"Change of % for each step along the {span}.",
                        isPlane ? u"Δ% = ((%₂ − %₀)·(x₁ − x₀) − (%₁ − %₀)·(x₂ − x₀))/A"
                                : u"Δ% = (%_{hi} − %_{lo})/({a}_{hi} − {a}_{lo})",
                        Group::ColourRates, exact));
    names.append(columns,
                 column(u"first %", u"levels", u"Level of % at the {span}'s first drawn pixel.",
                        isDirect ? u"first % = %₀ + ((%₁ − %₀)·(y₂ − y₀) − (%₂ − %₀)·(y₁ − "
                                   u"y₀))/A·(x − x₀) + Δ%·(y_s − y₀)"
                                 : u"first % = %_{lo} + ({a}_s − {a}_{lo})·Δ%",
                        Group::FirstColour, exact));
}

} // namespace

std::vector<TraceColumn> edgeWalkSetUpColumns(const EdgeWalkTable &table)
{
    const WalkNames names(table);
    std::vector<TraceColumn> columns;
    const auto add = [&](const QString &id, const QString &title, const char16_t *unit,
                         const char16_t *toolTip, const QString &formula) {
        TraceColumn added = column(u"", unit, toolTip, u"", Group::Position);
        added.id = id;
        added.title = title;
        added.formula = formula;
        names.append(columns, added);
    };
    const std::array<char16_t, 3> digits = {u'₀', u'₁', u'₂'};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const QChar digit = digits[corner];
        const QString file = QString::number(corner);
        add(text(u"x_") + file, u'x' + QString(digit), u"px", u"A vertex, sorted.", {});
        add(text(u"y_") + file, u'y' + QString(digit), u"px", u"A vertex, sorted.", {});
        add(text(u"%_") + file, u'%' + QString(digit), u"levels", u"A level of a vertex.", {});
    }
    add(text(u"A"), text(u"A"), u"px²", u"Twice the signed area.",
        text(u"A = (x₁ − x₀)·(y₂ − y₀) − (x₂ − x₀)·(y₁ − y₀)"));
    const std::array<std::array<std::size_t, 2>, 3> ends = {{{0, 1}, {1, 2}, {0, 2}}};
    const bool isRow = table.axis == SpanAxis::Row;
    // Rows are walked from the top down, columns from left to right.
    const QString way = isRow ? text(u"(y@ − y&)") : text(u"(x& − x@)");
    const auto ofEdge = [&](QString pattern, const std::array<std::size_t, 2> &edge) {
        pattern.replace(u'@', QChar(digits[edge[0]]));
        return pattern.replace(u'&', QChar(digits[edge[1]]));
    };
    for (const auto &edge : ends)
        add(QStringLiteral("m_%1%2").arg(edge[0]).arg(edge[1]), ofEdge(text(u"m@&"), edge),
            u"px/{span}", u"What each {span} adds to the edge's position; 0 along a {span}.",
            ofEdge(text(u"m@& = ({a}& − {a}@)/") + way, edge));
    for (const auto &edge : ends)
        add(QStringLiteral("rate_%_%1%2").arg(edge[0]).arg(edge[1]), ofEdge(text(u"δ%@&"), edge),
            u"levels/{span}", u"What each {span} adds to % along the edge.",
            ofEdge(text(u"δ%@& = (%& − %@)/") + way, edge));
    if (table.form == WalkForm::Direct) {
        for (const auto &edge : ends)
            add(QStringLiteral("proved_%1%2").arg(edge[0]).arg(edge[1]),
                ofEdge(text(u"proved@&"), edge), u"",
                u"1: the edge lies within the proved domain and is computed in float64; 0: outside "
                u"of it, in integers.",
                {});
    }
    return columns;
}

std::vector<TraceColumn> edgeWalkSpanColumns(const EdgeWalkTable &table)
{
    const WalkNames names(table);
    const bool isDirect = table.form == WalkForm::Direct;
    const auto exact = Comparison::WithExact;
    std::vector<TraceColumn> columns = {triangleColumn()};
    names.append(columns, column(u"{c}", u"px", u"The {span}.", u"", Group::Position));
    names.append(columns,
                 column(u"{part}", u"", u"1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂.", u"",
                        Group::Position));
    appendBounds(columns, names);
    names.append(columns,
                 column(u"first", u"px", u"The first covered sample of the {span}.",
                        isDirect ? u"first = ⌈{a}_{lo} − β_{lo}⌉" : u"first = ⌈{a}_{lo}⌉",
                        Group::Span, exact));
    names.append(columns,
                 column(u"last", u"px", u"The last covered sample of the {span}.",
                        isDirect ? u"last = ⌊{a}_{hi} + β_{hi}⌋ (closed), ⌈{a}_{hi} − β_{hi}⌉ − 1 "
                                   u"(otherwise)"
                                 : u"last = ⌊{a}_{hi}⌋ (closed), ⌈{a}_{hi}⌉ − 1 (otherwise)",
                        Group::Span, exact));
    names.append(
        columns,
        column(u"px", u"", u"Pixels written in this {span}, inside the frame.", u"", Group::Span));
    names.append(
        columns,
        column(u"{a}_s", u"px", u"The first sample that lies inside the frame.", u"", Group::Span));
    appendEdges(columns, names);
    appendColours(columns, names);
    return columns;
}

std::vector<TraceColumn> edgeWalkSampleColumns()
{
    const WalkNames names({});
    std::vector<TraceColumn> columns;
    names.append(columns,
                 startingWith(column(u"%", u"levels", u"Level of % at the sample.", u"% ← %′ + Δ%",
                                     Group::FirstColour, Comparison::WithExact),
                              u"% ← first %"));
    return columns;
}

} // namespace pixelplumb
