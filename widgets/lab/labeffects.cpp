// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labeffects.h"

#include "core/scan/choicenames.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/numberlayout.h"

#include <QHeaderView>

namespace pixelplumb {

namespace {

enum EffectColumn {
    WayColumn,
    ArithmeticColumn,
    TimeColumn,
    RatioColumn,
    ErrorColumn,
    WrongColumn,
    DistanceColumn,
    columnCount
};

bool isFigure(int column) { return column >= TimeColumn; }

/// "2.31 (2.28 to 2.40)": the median and the middle half.
QString spreadText(const Spread &spread)
{
    return LabEffects::tr("%1 to %2 in the middle half of the rounds")
        .arg(figureText(spread.lower), figureText(spread.upper));
}

} // namespace

LabEffects::LabEffects(QWidget *parent)
    : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("labEffects"));
    setAccessibleName(tr("What effects cost and what they mend"));
    setColumnCount(columnCount);
    setHeaderLabels({tr("scene, and how it is drawn"), tr("arithmetic"), tr("ns a pixel"),
                     tr("× first"), tr("error, levels"), tr("wrong pixels"),
                     tr("off the surface")});
    headerItem()->setToolTip(TimeColumn, tr("The median of all rounds, by the plain kernels"));
    headerItem()->setToolTip(RatioColumn,
                             tr("Beside the first row of the scene in the same arithmetic"));
    headerItem()->setToolTip(ErrorColumn,
                             tr("Root of the mean square over pixels and channels, from the exact "
                                "area or from the truth of all effects"));
    headerItem()->setToolTip(WrongColumn, tr("Pixels in other bytes than that"));
    headerItem()->setToolTip(DistanceColumn,
                             tr("Largest distance of the triangles from the surface"));
    for (int column = 0; column < columnCount; ++column)
        headerItem()->setTextAlignment(
            column, (isFigure(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setStretchLastSection(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true);
    setFont(tabularFont(font()));
}

void LabEffects::show(const Study &study)
{
    clear();
    QTreeWidgetItem *group = nullptr;
    for (const EffectRow &row : study.effects) {
        if (!group || group->text(WayColumn) != row.group) {
            group = new QTreeWidgetItem(this, {row.group});
            group->setExpanded(true);
        }
        auto *item = new QTreeWidgetItem(group);
        const auto put = [item](EffectColumn column, const QString &text) {
            item->setText(column, text);
            item->setTextAlignment(
                column, (isFigure(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        };
        put(WayColumn, row.way);
        put(ArithmeticColumn, nameText(nameOf(row.arithmetic)));
        if (row.perPixel) {
            put(TimeColumn, figureText(row.perPixel->median));
            item->setToolTip(TimeColumn, spreadText(*row.perPixel));
        }
        if (row.timesFirst) {
            put(RatioColumn, figureText(row.timesFirst->median));
            item->setToolTip(RatioColumn, spreadText(*row.timesFirst));
        }
        put(ErrorColumn, figureText(row.rms));
        put(WrongColumn, QString::number(row.wrongPixels));
        if (row.distance)
            put(DistanceColumn, QString::number(*row.distance, 'g', 3));
    }
}

} // namespace pixelplumb
