// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labeffects.h"

#include "core/scan/choicenames.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/signs.h"

#include <QHeaderView>

namespace pixelplumb {

namespace {

enum class EffectColumn { Way, Arithmetic, Time, Ratio, Error, Wrong, Distance, Brightness };
constexpr int effectColumns = int(EffectColumn::Brightness) + 1;

Qt::Alignment alignmentOf(int column)
{
    return (column >= int(EffectColumn::Time) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
}

QString middleHalfText(const Spread &spread)
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
    setColumnCount(effectColumns);
    setHeaderLabels({tr("scene, and how it is drawn"), tr("arithmetic"), tr("ns a pixel"),
                     tr("× first"), tr("error, levels"), tr("wrong pixels"), tr("off the surface"),
                     tr("brightness")});
    headerItem()->setToolTip(int(EffectColumn::Time),
                             tr("The median of all rounds, by the plain kernels"));
    headerItem()->setToolTip(int(EffectColumn::Ratio),
                             tr("Beside the first row of the scene in the same arithmetic: the "
                                "median of the rounds' own ratios, which differs from the ratio "
                                "of the medians where the machine did other work"));
    headerItem()->setToolTip(int(EffectColumn::Error),
                             tr("Root of the mean square over pixels and channels, from the exact "
                                "area or from the truth of all effects"));
    headerItem()->setToolTip(int(EffectColumn::Wrong), tr("Pixels in other bytes than that"));
    headerItem()->setToolTip(int(EffectColumn::Distance),
                             tr("Largest distance of the triangles from the surface"));
    headerItem()->setToolTip(int(EffectColumn::Brightness),
                             tr("How bright a line is for each pixel of its length: 1 is one pixel "
                                "of white; beside the lines' heading, least to greatest of all "
                                "directions"));
    for (int column = 0; column < effectColumns; ++column)
        headerItem()->setTextAlignment(column, alignmentOf(column));
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
        if (!group || group->text(int(EffectColumn::Way)) != row.group) {
            group = new QTreeWidgetItem(this, {row.group});
            group->setExpanded(true);
            if (const auto range = brightnessRangeOf(study.effects, row.group)) {
                group->setText(
                    int(EffectColumn::Brightness),
                    tr("%1 to %2").arg(figureText(range->least), figureText(range->greatest)));
                group->setTextAlignment(int(EffectColumn::Brightness),
                                        alignmentOf(int(EffectColumn::Brightness)));
            }
        }
        auto *item = new QTreeWidgetItem(group);
        const auto put = [item](EffectColumn column, const QString &text) {
            item->setText(int(column), text);
            item->setTextAlignment(int(column), alignmentOf(int(column)));
        };
        put(EffectColumn::Way, row.way);
        put(EffectColumn::Arithmetic, nameText(nameOf(row.arithmetic)));
        if (row.perPixel) {
            put(EffectColumn::Time, figureText(row.perPixel->median));
            item->setToolTip(int(EffectColumn::Time), middleHalfText(*row.perPixel));
        }
        if (row.timesFirst) {
            put(EffectColumn::Ratio, figureText(row.timesFirst->median));
            item->setToolTip(int(EffectColumn::Ratio), middleHalfText(*row.timesFirst));
            if (row.isTooSlow()) {
                put(EffectColumn::Ratio,
                    tr("%1, over %2")
                        .arg(figureText(row.timesFirst->median), QString::number(mostTimesLoop)));
                item->setForeground(int(EffectColumn::Ratio), signColour(Sign::Extra, palette()));
            }
        }
        put(EffectColumn::Error, figureText(row.rms));
        put(EffectColumn::Wrong, QString::number(row.wrongPixels));
        if (row.distance)
            put(EffectColumn::Distance, QString::number(*row.distance, 'g', 3));
        if (row.brightness)
            put(EffectColumn::Brightness, figureText(*row.brightness));
    }
}

} // namespace pixelplumb
