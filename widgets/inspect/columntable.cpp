// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntable.h"

#include "widgets/inspect/tableparts.h"
#include "widgets/look/parts.h"
#include "widgets/model/columntablemodel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"

#include <algorithm>
#include <numeric>

namespace pixelplumb {

namespace {

constexpr int rowPadding = 2;
constexpr int measuredRows = 256; // enough for all rows of a usual run
constexpr int usualRows = 8; // in sight

/// Rows spread evenly over the table, including the first and the last: in between, numbers change
/// evenly and denominators repeat.
std::vector<int> sampledRows(int rowCount)
{
    std::vector<int> rows;
    const int count = std::min(rowCount, measuredRows);
    for (int i = 0; i < count; ++i)
        rows.push_back(count == 1 ? 0 : int(std::int64_t(rowCount - 1) * i / (count - 1)));
    return rows;
}

} // namespace

ColumnTable::ColumnTable(Playhead *playhead, QWidget *parent)
    : QTableView(parent)
    , m_playhead(playhead)
    , m_model(new ColumnTableModel(playhead, this))
    , m_delegate(new ColumnTableDelegate(this))
    , m_header(new ColumnTableHeader(this))
{
    named(this, "columnTable", tr("Columns of the scan"));
    setAccessibleDescription(
        tr("A row for each column; the highlighted row is the current column."));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setWordWrap(false);
    setCornerButtonEnabled(false);
    if (auto *corner = findChild<QAbstractButton *>())
        corner->setMaximumSize(0, 0); // the style would draw it as a button
    setTabKeyNavigation(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setItemDelegate(m_delegate);
    setHorizontalHeader(m_header);
    setVerticalHeader(new RowMarkHeader(this));
    createActions();
    setModel(m_model);

    connect(m_model, &QAbstractItemModel::modelReset, this, &ColumnTable::takeColumns);
    connect(playhead, &Playhead::positionChanged, this, &ColumnTable::followPlayhead);
    connect(m_header, &QWidget::customContextMenuRequested, this,
            [this](const QPoint &position) { showColumnMenu(m_header->mapToGlobal(position)); });
    takeColumns();
}

ColumnTable::~ColumnTable() = default;

QSize ColumnTable::sizeHint() const
{
    const int row = verticalHeader()->defaultSectionSize();
    // The top of a ninth row says that there are more.
    return {QTableView::sizeHint().width(),
            m_header->sizeHint().height() + usualRows * row + row / 3};
}

void ColumnTable::takeColumns()
{
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + rowPadding);
    m_exactAction->setEnabled(m_model->isRounding());
    m_errorAction->setEnabled(m_model->isRounding());
    for (int group = 0; group < int(m_groupActions.size()); ++group)
        m_groupActions[group]->setVisible(hasGroup(NumberGroup(group)));
    showChosenColumns();
    followPlayhead();
}

/// Fits only the visible columns: most exact numbers and errors would be measured for nothing.
void ColumnTable::fitColumns()
{
    const QList<int> columns = shownColumns();
    m_delegate->measure(*m_model, columns, sampledRows(m_model->rowCount()), font());
    for (const int column : columns)
        setColumnWidth(column,
                       std::max(m_delegate->cellWidth(column), m_header->titleWidth(column)));
}

void ColumnTable::followPlayhead()
{
    const QScopedValueRollback following(m_following, true);
    const std::optional<std::size_t> span = m_playhead->currentSpan();
    const int row = span ? m_model->rowAt(*span) : firstRowAhead();
    if (!span || row >= m_model->rowCount() || m_model->spanAt(row) != *span) {
        selectionModel()->clear();
        bringIntoView(row);
        return;
    }
    if (currentIndex().row() != row) {
        setAutoScroll(false); // it would scroll sideways too
        const int section = std::max(0, m_header->logicalIndexAt(0));
        selectionModel()->setCurrentIndex(m_model->index(row, section),
                                          QItemSelectionModel::ClearAndSelect
                                              | QItemSelectionModel::Rows);
        setAutoScroll(true);
    }
    if (!m_isPressed)
        bringIntoView(row);
}

/// The first column of the triangle being set up, else of the first triangle.
int ColumnTable::firstRowAhead() const
{
    const std::optional<TraceStep> step = m_playhead->currentStep();
    return step ? m_model->rowAt(m_playhead->traced()->trace->firstSpanOf(step->primitive)) : 0;
}

void ColumnTable::bringIntoView(int row)
{
    if (row >= m_model->rowCount())
        return;
    const int height = rowHeight(row);
    const int top = rowViewportPosition(row);
    const int pageHeight = viewport()->height();
    const int context = std::clamp((pageHeight - height) / 2, 0, height); // a row before and after
    QScrollBar *bar = verticalScrollBar();
    const int firstShown = bar->value() / height;
    if (top < context)
        bar->setValue((row - 1) * height);
    else if (top + height + context > pageHeight)
        // Whole rows, with one after the current row if there is room for both.
        bar->setValue(std::min(row, std::max(firstShown, row + 3 - pageHeight / height)) * height);
}

void ColumnTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    if (const std::optional<std::size_t> span = m_playhead->currentSpan())
        bringIntoView(m_model->rowAt(*span));
}

void ColumnTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (!m_following && current.isValid() && current.row() != previous.row())
        m_playhead->seekToSpan(m_model->spanAt(current.row()));
}

QString ColumnTable::selectionAsTsv() const
{
    QList<int> rows;
    for (const QModelIndex &index : selectionModel()->selectedRows())
        rows.append(index.row());
    std::ranges::sort(rows);
    return asTsv(rows);
}

QString ColumnTable::asTsv(const QList<int> &rows) const
{
    QList<int> columns;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        // On the screen the row headers show the primitive.
        const bool tellsRowsApart = m_model->hasSeveralPrimitives()
            && m_model->fileName(column) == QLatin1String("primitive");
        if (!isColumnHidden(column) || tellsRowsApart)
            columns.append(column);
    }
    QStringList names;
    for (const int column : std::as_const(columns))
        names.append(m_model->fileName(column));
    QStringList lines(names.join(u'\t'));
    for (const int row : rows) {
        QStringList cells;
        for (const int column : std::as_const(columns))
            cells.append(
                m_model->index(row, column).data(ColumnTableModel::CanonicalTextRole).toString());
        lines.append(cells.join(u'\t'));
    }
    return lines.join(u'\n') + u'\n';
}

void ColumnTable::copySelection() const
{
    if (selectionModel()->hasSelection())
        QGuiApplication::clipboard()->setText(selectionAsTsv());
}

void ColumnTable::copyAll() const
{
    QList<int> rows(m_model->rowCount());
    std::iota(rows.begin(), rows.end(), 0);
    QGuiApplication::clipboard()->setText(asTsv(rows));
}

void ColumnTable::setFilter(RowFilter filter)
{
    if (filter != m_model->filter())
        m_model->setFilter(filter);
}

bool ColumnTable::event(QEvent *event)
{
    // The window also uses the copy key; in the table it copies the table's rows.
    if (event->type() == QEvent::ShortcutOverride
        && static_cast<QKeyEvent *>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void ColumnTable::mousePressEvent(QMouseEvent *event)
{
    m_isPressed = true;
    QTableView::mousePressEvent(event);
}

void ColumnTable::mouseReleaseEvent(QMouseEvent *event)
{
    QTableView::mouseReleaseEvent(event);
    m_isPressed = false;
}

void ColumnTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
        return;
    }
    QTableView::keyPressEvent(event);
}

void ColumnTable::focusInEvent(QFocusEvent *event)
{
    // Without a current row the base class selects the first; getting the focus must not move
    // there.
    const QScopedValueRollback following(m_following, true);
    QTableView::focusInEvent(event);
}

void ColumnTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange && m_copyAction)
        takeColumns();
}

void ColumnTable::paintEvent(QPaintEvent *event)
{
    QTableView::paintEvent(event);
    if (m_model->rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const bool isFiltered = m_model->filter() != RowFilter::All && m_playhead->traced()
        && m_playhead->traced()->trace->spanCount() > 0;
    painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     isFiltered ? tr("No row is of the chosen kind.")
                                : emptyRunText(m_playhead->traced()));
}

} // namespace pixelplumb
