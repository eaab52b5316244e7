// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/symbolruns.h"
#include "widgets/look/signs.h"

#include <QtGui>

#include <optional>
#include <vector>

namespace pixelplumb {

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
