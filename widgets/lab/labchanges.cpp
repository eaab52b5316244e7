// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labchanges.h"

#include "core/grade/showntext.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberlayout.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

namespace pixelplumb {

namespace {

QString labelIn(const Study &before, const Study &after, const QString &contender)
{
    for (const Study *study : {&after, &before}) {
        if (const StudyContender *found = study->contender(contender))
            return found->label;
    }
    return contender;
}

/// The glyph tells it as well as the word.
QString changeText(LabChange change)
{
    switch (change) {
    case LabChange::Faster:
        return QStringLiteral("▼ ") + coreWord(nameOf(change));
    case LabChange::Slower:
        return QStringLiteral("▲ ") + coreWord(nameOf(change));
    case LabChange::WithinSpread:
    case LabChange::NotComparable:
        break;
    }
    return coreWord(nameOf(change));
}

} // namespace

LabChanges::LabChanges(QWidget *parent)
    : QWidget(parent)
    , m_summary(new QLabel(this))
    , m_table(new QTableWidget(this))
{
    setObjectName(QStringLiteral("labChanges"));
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setAccessibleName(tr("What changed"));
    m_table->setObjectName(QStringLiteral("labChangesTable"));
    m_table->setAccessibleName(tr("Before and after"));
    const QStringList headers
        = {tr("contender"), tr("family"), tr("before, ns a pixel"), tr("after, ns a pixel"),
           tr("×"),         tr("time"),   tr("wrong before, ppm"),  tr("wrong after, ppm")};
    m_table->setColumnCount(int(headers.size()));
    m_table->setHorizontalHeaderLabels(headers);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setAlternatingRowColors(true);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_table->setFont(tabularFont(font()));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
}

void LabChanges::show(const Study &before, const Study &after, const QString &beforeName)
{
    const LabComparison comparison = compareStudies(before, after);
    QString summary = tr("Before: %1. %2 faster, %3 slower, %4 within their spread.")
                          .arg(beforeName, QString::number(comparison.count(LabChange::Faster)),
                               QString::number(comparison.count(LabChange::Slower)),
                               QString::number(comparison.count(LabChange::WithinSpread)));
    const auto changed
        = std::ranges::count_if(comparison.rows, &LabRowComparison::isAccuracyChanged);
    summary += u' '
        + (changed == 0 ? tr("No accuracy changed.")
                        : tr("≠ Accuracy changed in %n rows.", nullptr, int(changed)));
    if (const std::int64_t missing = comparison.countMissing(); missing > 0)
        summary += u' ' + tr("%n rows are missing.", nullptr, int(missing));
    for (const QString &remark : comparison.remarks)
        summary += QStringLiteral(" ⚠ ") + remark;
    m_summary->setText(escapedControls(summary));
    fill(comparison, before, after);
}

void LabChanges::fill(const LabComparison &comparison, const Study &before, const Study &after)
{
    m_table->setSortingEnabled(false);
    m_table->setRowCount(int(comparison.rows.size()));
    for (int line = 0; line < m_table->rowCount(); ++line) {
        const LabRowComparison &row = comparison.rows[std::size_t(line)];
        const auto spread = [](const std::optional<Spread> &time) {
            return time ? spreadText(*time) : QString();
        };
        const auto figure = [](const std::optional<double> &value) {
            return value ? figureText(*value) : QString();
        };
        const QStringList cells = {labelIn(before, after, row.contender),
                                   row.family,
                                   spread(row.before),
                                   spread(row.after),
                                   figure(row.timesBefore),
                                   changeText(row.change),
                                   figure(row.wrongBefore),
                                   (row.isAccuracyChanged() ? QStringLiteral("≠ ") : QString())
                                       + figure(row.wrongAfter)};
        for (int column = 0; column < int(cells.size()); ++column) {
            auto *cell = new QTableWidgetItem(cells[column]);
            const bool isText = column < 2 || column == 5;
            cell->setTextAlignment((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            m_table->setItem(line, column, cell);
        }
    }
    m_table->resizeColumnsToContents();
}

} // namespace pixelplumb
