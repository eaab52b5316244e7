// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labanswers.h"

#include "core/scan/choicenames.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

#include <QHeaderView>

namespace pixelplumb {

namespace {

constexpr int reasonColumn = 4; ///< of the answers, the last one
constexpr int leastReason = 320; ///< width of its column, logical pixels

QString groundText(const BudgetAnswer &answer)
{
    switch (answer.ground) {
    case BudgetGround::Proof:
        return kernelOf(answer.contender) == LabKernel::Plain ? LabAnswers::tr("proof")
                                                              : LabAnswers::tr("proof and test");
    case BudgetGround::Measurement:
        return LabAnswers::tr("measurement");
    case BudgetGround::Nobody:
        break;
    }
    return LabAnswers::tr("nobody");
}

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

LabAnswers::LabAnswers(QWidget *parent)
    : QTableView(parent)
{
    named(this, "labAnswers", tr("The cheapest contender for each budget"));
    m_model = new RowsModel<Row>(
        {{tr("budget"), tr("What is asked for"),
          [](const Row &row) { return coreWord(textOf(row.answer.budget)); }, Qt::AlignLeft},
         {tr("cheapest contender"),
          tr("The fastest contender that meets this limit on this family of "
             "triangles"),
          [](const Row &row) { return row.contender; }, Qt::AlignLeft},
         {tr("known by"),
          tr("Whether it is proved, or only observed in this study. Tests "
             "check that a SIMD kernel writes what the proved plain kernel "
             "writes"),
          [](const Row &row) { return groundText(row.answer); }, Qt::AlignLeft},
         {tr("ns a pixel"), tr("The median of all rounds"),
          [](const Row &row) {
              const double time = row.answer.nanosecondsPerPixel;
              return time > 0 ? figureText(time) : QString();
          }},
         {tr("reason"), {}, [](const Row &row) { return row.answer.reason; }, Qt::AlignLeft}},
        this);
    setModel(m_model);
    readByRows(this);
    setWordWrap(true);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(reasonColumn, QHeaderView::Stretch);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &current) {
                if (current.isValid())
                    emit contenderSelected(
                        m_model->rows()[std::size_t(current.row())].answer.contender);
            });
}

/// The reasons take the remaining width; if that is too little, the table scrolls.
void LabAnswers::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    int others = 0;
    for (int column = 0; column < reasonColumn; ++column)
        others += columnWidth(column);
    const bool isRoom = viewport()->width() - others >= leastReason;
    horizontalHeader()->setSectionResizeMode(reasonColumn,
                                             isRoom ? QHeaderView::Stretch : QHeaderView::Fixed);
    if (!isRoom)
        setColumnWidth(reasonColumn, leastReason);
}

void LabAnswers::show(const Study &study, const QString &family)
{
    std::vector<Row> rows;
    for (const Budget budget : allBudgets) {
        const BudgetAnswer answer = cheapestFor(budget, study, family);
        const StudyContender *contender = study.contender(answer.contender);
        rows.push_back({answer, contender ? contender->label : answer.contender});
    }
    m_model->setRows(std::move(rows));
}

LabEffects::LabEffects(QWidget *parent)
    : QTreeWidget(parent)
{
    named(this, "labEffects", tr("What effects cost and what they mend"));
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
