// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/operationpanel.h"

#include "core/frame/framebuffer.h"
#include "core/lab/counting/operationtable.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

QTableWidgetItem *figureItem(const QString &text)
{
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

} // namespace

OperationPanel::OperationPanel(Playhead *playhead, QWidget *parent)
    : StudyPanel("operations", tr("Operations"), parent)
    , m_playhead(playhead)
    , m_table(new QTableWidget(this))
{
    m_summary = readingLabel("operationSummary", tr("What was counted"), this);
    named(m_table, "operationTable", tr("Operations by kind"),
          tr("What the method's numbers do, counted while they draw this scene: on "
             "the average of a set-up, a span and a sample, and all together. Whole "
             "pixel coordinates and the clamp to a byte are not counted."));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setColumnCount(4);
    m_table->setHorizontalHeaderLabels({tr("a set-up"), tr("a span"), tr("a sample"), tr("all")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->setFont(tabularFont(font()));
    withParts(new QVBoxLayout(this), {m_summary, {m_table, 1}}, 8, 8);
    connect(playhead, &Playhead::tracedChanged, this, &OperationPanel::forget);
    forget();
}

void OperationPanel::forget()
{
    m_counts.reset();
    restart();
}

bool OperationPanel::beginStudy()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!traced) {
        fillTable();
        tell(tr("The scene is being drawn."));
        return false;
    }
    if (!isCounted(*traced->method)) {
        fillTable();
        tell(countingGap(*traced->method, traced->scene.settings.arithmetic));
        return true;
    }
    m_job.start(
        [traced](const ProgressListener &listener) {
            const FrameBuffer frame(traced->scene.frame);
            return countOperations(*traced->method, traced->scene.settings, traced->primitives,
                                   frame.view(), listener);
        },
        [this](std::optional<OperationCounts> counts) { take(std::move(counts)); });
    return true;
}

void OperationPanel::take(std::optional<OperationCounts> counts)
{
    m_counts = std::move(counts);
    fillTable();
    const TracedScene *traced = m_playhead->traced();
    if (!m_counts || !traced) {
        tell(tr("The count does not fit into memory. Make the frame smaller."));
    } else {
        const Arithmetic arithmetic = traced->scene.settings.arithmetic;
        const QString counted = coreWords(countsText(*m_counts), QStringLiteral(", "));
        tell(QStringList{tr("%1 in %2: %3; the set-up is %4 % of them.")
                             .arg(methodTitle(*traced->method), nameText(nameOf(arithmetic)),
                                  counted, QString::number(100 * m_counts->setUpShare(), 'f', 1)),
                         countingGap(*traced->method, arithmetic)}
                 .join(u' ')
                 .trimmed());
    }
    emit counted();
}

void OperationPanel::fillTable()
{
    const std::vector<OperationTableRow> rows
        = m_counts ? operationTable(*m_counts) : std::vector<OperationTableRow>();
    m_table->setRowCount(int(rows.size()));
    for (int row = 0; row < int(rows.size()); ++row) {
        const OperationTableRow &shown = rows[std::size_t(row)];
        m_table->setVerticalHeaderItem(row, new QTableWidgetItem(coreWord(shown.name)));
        for (int stage = 0; stage < int(shown.each.size()); ++stage)
            m_table->setItem(row, stage, figureItem(operationText(shown.each[std::size_t(stage)])));
        m_table->setItem(row, 3, figureItem(QString::number(shown.all)));
    }
}

} // namespace pixelplumb
