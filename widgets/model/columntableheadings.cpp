// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracetable.h"
#include "core/runs/spanheadings.h"
#include "widgets/look/corewords.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/columntablemodel.h"

/// The names of the table's rows and columns.
namespace pixelplumb {

namespace {

/// The mark at the first row of a primitive: "△ 2", "line 0".
QString markText(const TracedScene &traced, std::size_t span)
{
    const std::size_t primitive = traced.trace->primitiveOf(span);
    const QString kind = traced.primitives.isTriangle(primitive)
        ? u"△"_s
        : coreWord(nameOf(traced.primitives.kindOf(primitive)));
    return u"%1 %2"_s.arg(kind, QString::number(primitive));
}

/// The edge added where a sorted triangle's second part begins, else the part's name.
QString partText(const TracedScene &traced, std::size_t span)
{
    if (traced.primitives.isTriangle(traced.trace->primitiveOf(span)))
        return u"L₁₂"_s;
    return coreWord(partName(*traced.trace, span));
}

} // namespace

QString ColumnTableModel::fileName(int column) const
{
    switch (face(column)) {
    case NumberFace::Used:
        break;
    case NumberFace::Exact:
        return exactName(number(column).id);
    case NumberFace::Error:
        return errorName(number(column).id);
    }
    return number(column).id;
}

QVariant ColumnTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        if (role != Qt::DisplayRole || section >= rowCount())
            return {};
        const std::size_t span = spanAt(section);
        switch (markOf(span)) {
        case RowMark::None:
            break;
        case RowMark::PrimitiveBegins:
            return markText(*m_traced, span);
        case RowMark::PartBegins:
            return partText(*m_traced, span);
        }
        return QString();
    }
    if (section >= columnCount())
        return {};
    const NumberDescription &shown = number(section);
    if (role == Qt::DisplayRole) {
        const QString title = coreWord(shown.title);
        switch (face(section)) {
        case NumberFace::Used:
            break;
        case NumberFace::Exact:
            return tr("%1 exact").arg(title);
        case NumberFace::Error:
            return tr("%1 error").arg(title);
        }
        return title;
    }
    if (role == Qt::ToolTipRole)
        return numberToolTip(shown);
    if (role == Qt::AccessibleTextRole)
        return withoutMarkup(headerData(section, orientation, Qt::DisplayRole).toString());
    return {};
}

} // namespace pixelplumb
