// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/symbolruns.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// "²": it belongs to the whole symbol, not to a subscript before it.
bool isExponent(QChar character) { return u"⁰¹²³⁴⁵⁶⁷⁸⁹"_s.contains(character); }

} // namespace

std::vector<SymbolRun> symbolRuns(const QString &text)
{
    using Level = SymbolRun::Level;
    std::vector<SymbolRun> runs;
    const auto append = [&runs](QChar character, Level level) {
        if (runs.empty() || runs.back().level != level)
            runs.push_back({{}, level});
        runs.back().text += character;
    };
    for (qsizetype i = 0; i < text.size(); ++i) {
        const auto isLowered = [&](qsizetype at) {
            return at < text.size() && text[at].isLetterOrNumber() && !isExponent(text[at]);
        };
        if (text[i] != u'_' || !isLowered(i + 1)) {
            append(text[i], Level::Line);
            continue;
        }
        for (; isLowered(i + 1); ++i)
            append(text[i + 1], Level::Subscript);
    }
    return runs;
}

} // namespace pixelplumb
