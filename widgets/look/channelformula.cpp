// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/channelformula.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

/// Replaces the channel's letter by C: in "ΔR", but not the right bound in "x_R".
QString withoutChannel(QString symbols, QChar channel)
{
    const QRegularExpression letter(QStringLiteral("(?<![A-Za-z_])%1(?![A-Za-z])").arg(channel));
    return symbols.replace(letter, QStringLiteral("C"));
}

} // namespace

std::optional<QChar> channelOf(const FormulaLine &line)
{
    switch (line.subject) {
    case NumberSubject::Red:
        return u'R';
    case NumberSubject::Green:
        return u'G';
    case NumberSubject::Blue:
        return u'B';
    default:
        return std::nullopt;
    }
}

std::vector<ChannelFormula> channelFormulas(std::span<const FormulaLine> lines)
{
    std::vector<ChannelFormula> formulas;
    for (const FormulaLine &line : lines) {
        const std::optional<QChar> channel = channelOf(line);
        if (!channel)
            continue;
        const QString symbols = withoutChannel(line.symbols, *channel);
        const auto isOpen = [&](const ChannelFormula &formula) {
            return formula.symbols == symbols
                && std::ranges::none_of(formula.lines, [&](const FormulaLine *other) {
                       return other->subject == line.subject;
                   });
        };
        const auto formula = std::ranges::find_if(formulas, isOpen);
        if (formula == formulas.end())
            formulas.push_back({symbols, {&line}});
        else
            formula->lines.push_back(&line);
    }
    return formulas;
}

} // namespace pixelplumb
