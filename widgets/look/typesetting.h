// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/runs/explain/explanation.h"
#include "core/scan/scansettings.h"
#include "core/trace/numberdescription.h"
#include "core/trace/symbolruns.h"
#include "widgets/look/signs.h"

#include <QtGui>

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// Text with true minus signs, and no-break thin spaces in mixed numbers: "12 5/54".
QString typeset(QString text);

/// typeset() as rich text, with symbols (SymbolText) and smaller fractions, so that 7 11/54 is not
/// read as 711/54.
QString typesetHtml(const QString &text);

/// The name of a file as titles, labels and menus show it: shortened where it is very long,
/// unprintable characters as their codes.
QString shownName(const QString &path);

/// A title or formula without the markup of subscripts: "yB".
QString withoutMarkup(QString symbols);

/// The tool tip of a number: what it is and where it comes from.
QString numberToolTip(const NumberDescription &number);
/// The tool tip with the number's current value, and the exact one where there is one to compare.
QString numberToolTip(const NumberDescription &number, const Quantity &used, const Quantity &exact,
                      Arithmetic arithmetic);

/// One formula of the channels. Red, green and blue share the symbols, which then need to be read
/// only once.
struct ChannelFormula {
    QString symbols; ///< with C for the channel: "C ← C + ΔC"
    std::vector<const FormulaLine *> lines; ///< at most one per channel
};

/// Groups the colour formulas of an explanation, in the order of their first lines. `lines` must
/// outlive the result.
std::vector<ChannelFormula> channelFormulas(std::span<const FormulaLine> lines);

/// The channel of a line's subject; none where the subject is no colour.
std::optional<QChar> channelOf(const FormulaLine &line);

/// A formula's symbols with their subscripts (symbolRuns).
class SymbolText {
public:
    explicit SymbolText(const QString &text);

    /// Rich text with <sub>.
    QString html() const;

    double width(const QFont &font) const;
    /// Draws in the painter's pen; returns the width.
    double draw(QPainter &painter, const QPointF &baseline, const QFont &font) const;

private:
    static QFont fontFor(SymbolRun::Level level, const QFont &font);

    std::vector<SymbolRun> m_runs;
};

/// A tool tip's lines as rich text, with their subscripts.
QString toolTipHtml(const QStringList &lines);

/// The edge to which a symbol belongs: the lower one with subscript B, the upper one with T.
std::optional<Sign> edgeSignOf(const QString &symbol);

} // namespace pixelplumb
