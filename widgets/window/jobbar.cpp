// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/jobbar.h"

#include "widgets/look/corewords.h"
#include "widgets/model/job.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace pixelplumb {

JobBar::JobBar(const Job *job, const Names &names, QWidget *parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_bar(new QProgressBar(this))
{
    m_bar->setObjectName(names.bar);
    m_bar->setAccessibleName(names.barInWords);
    m_bar->setFixedWidth(160);
    m_bar->setMaximumHeight(16);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_title);
    row->addWidget(m_bar);
    hide();
    connect(job, &Job::started, this, [this, job] { begin(job->title()); });
    connect(job, &Job::progressChanged, this, &JobBar::tell);
    connect(job, &Job::ended, this, &QWidget::hide);
    if (names.cancel.isEmpty())
        return;
    auto *cancel = new QToolButton(this);
    cancel->setObjectName(names.cancel);
    cancel->setText(tr("Cancel"));
    cancel->setAccessibleName(names.cancelInWords);
    cancel->setAutoRaise(true);
    row->addWidget(cancel);
    connect(cancel, &QToolButton::clicked, this, &JobBar::cancelRequested);
}

void JobBar::begin(const QString &title)
{
    m_title->setText(title);
    m_bar->setRange(0, 0); // busy: the progress is unknown
    show();
}

/// Shows the progress. Each phase counts from 0; the tool tip names it.
void JobBar::tell(const JobProgress &progress)
{
    m_bar->setToolTip(coreWord(nameOf(progress.phase)));
    m_bar->setRange(0, progress.total > 0 ? 100 : 0);
    if (progress.total > 0)
        m_bar->setValue(int(100 * progress.done / progress.total));
}

} // namespace pixelplumb
