// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/operationpanel.h"

#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"

#include <QtWidgets>

namespace pixelplumb {

OperationPanel::OperationPanel(Playhead *playhead, QWidget *parent)
    : StudyPanel("operations", tr("Operations"), parent)
    , m_playhead(playhead)
{
    m_summary = readingLabel("operationSummary", tr("What was counted"), this);
    const auto each = [](std::size_t stage) {
        return [stage](const OperationTableRow &row) { return operationText(row.each[stage]); };
    };
    m_rows = new RowsModel<OperationTableRow>(
        {{tr("a set-up"), {}, each(0)},
         {tr("a span"), {}, each(1)},
         {tr("a sample"), {}, each(2)},
         {tr("all"), {}, [](const OperationTableRow &row) { return QString::number(row.all); }}},
        this, [](const OperationTableRow &row) { return coreWord(row.name); });
    auto *table = new QTableView(this);
    table->setModel(m_rows);
    named(table, "operationTable", tr("Operations by kind"),
          tr("The arithmetic operations of the method, counted while it draws "
             "this scene: on average for each set-up, span and sample, and in "
             "total. Whole pixel coordinates and the clamp to a byte are not "
             "counted."));
    readByRows(table);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    withParts(new QVBoxLayout(this), {m_summary, {table, 1}}, 8, 8);
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
        const QString counted = coreWords(countsText(*m_counts), u", "_s);
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
    m_rows->setRows(m_counts ? operationTable(*m_counts) : std::vector<OperationTableRow>());
}

} // namespace pixelplumb
