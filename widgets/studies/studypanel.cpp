// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/studypanel.h"

#include "widgets/look/parts.h"

namespace pixelplumb {

JobBar::JobBar(const Job &job, const QString &name, const QString &inWords, int width,
               QWidget *parent)
    : QWidget(parent)
{
    auto *bar = new QProgressBar(this);
    bar->setObjectName(name + u"Progress"_s);
    bar->setAccessibleName(inWords);
    bar->setTextVisible(false);
    if (width > 0)
        bar->setMaximumWidth(width);
    auto *cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(name + u"Cancel"_s);
    cancel->setAutoDefault(false);
    withParts(new QHBoxLayout(this), {{bar, 1}, cancel}, 8, 0);
    connect(cancel, &QPushButton::clicked, this, &JobBar::cancelled);
    connect(&job, &Job::started, this, [this, bar] {
        bar->setRange(0, 0); // busy: the progress is unknown
        show();
    });
    connect(&job, &Job::progressChanged, this, [this, bar](const JobProgress &progress) {
        bar->setRange(0, int(progress.total));
        bar->setValue(int(progress.done));
        show();
    });
    connect(&job, &Job::ended, this, &QWidget::hide);
    hide();
}

StudyPanel::StudyPanel(const char *name, const QString &inWords, QWidget *parent)
    : QWidget(parent)
{
    named(this, name, inWords);
    onEvents(this, {QEvent::Show}, [this] { studyIfDue(); });
}

void StudyPanel::restart()
{
    m_job.cancel();
    m_isStale = true;
    studyIfDue();
}

void StudyPanel::studyIfDue()
{
    if (!isVisible() || !std::exchange(m_isStale, false))
        return;
    if (!beginStudy())
        m_isStale = true;
}

void StudyPanel::tell(const QString &text)
{
    m_summary->setText(text);
    setAccessibleDescription(text);
}

} // namespace pixelplumb
