// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/symbolruns.h"
#include "widgets/look/signs.h"

#include <QFont>
#include <QPointF>
#include <QStringList>

#include <optional>
#include <vector>

class QPainter;

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

/// Lines of a tooltip, with their subscripts.
QString toolTipHtml(const QStringList &lines);

/// Which edge a symbol belongs to: what is lowered by B to the lower, by T to the upper one.
std::optional<Sign> edgeSignOf(const QString &symbol);

} // namespace pixelplumb
