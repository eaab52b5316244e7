// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/appearancenames.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/effectspanel.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

/// The controls above the table.
namespace pixelplumb {

QBoxLayout *EffectsPanel::controls()
{
    m_measure = new QPushButton(tr("Measure"), this);
    m_measure->setObjectName(QStringLiteral("effectsMeasure"));
    m_measure->setToolTip(tr("Draw the scene again and again with each effect on and off, all "
                             "others as called for, by the plain kernels"));
    m_cancel = new QPushButton(tr("Cancel"), this);
    m_cancel->setObjectName(QStringLiteral("effectsCancel"));
    m_cancel->setEnabled(false);
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_measure);
    row->addWidget(m_cancel);
    addSamples(row);
    row->addWidget(m_summary, 1);
    connect(m_measure, &QPushButton::clicked, this, &EffectsPanel::measure);
    connect(m_cancel, &QPushButton::clicked, this, &EffectsPanel::cancel);
    const auto showState = [this] {
        m_cancel->setEnabled(m_measureJob.isRunning());
        m_measure->setEnabled(!m_measureJob.isRunning());
    };
    connect(&m_measureJob, &Job::started, this, showState);
    connect(&m_measureJob, &Job::ended, this, showState);
    return row;
}

/// The samples that the scene itself asks for; the switch of antialiasing is next to its verdict.
void EffectsPanel::addSamples(QBoxLayout *row)
{
    m_samples = new QComboBox(this);
    m_samples->setObjectName(QStringLiteral("effectsSamples"));
    m_samples->setAccessibleName(tr("Antialiasing that the scene asks for"));
    m_samples->setToolTip(tr("Antialiasing that the scene asks for: samples of a pixel, or the "
                             "exact area; only pixels that an edge passes have more than one"));
    for (const Antialiasing each : {Antialiasing::None, Antialiasing::Samples4,
                                    Antialiasing::Samples16, Antialiasing::Area}) {
        const QString samples = QString::fromUtf8(nameOf(each));
        m_samples->addItem(each == Antialiasing::Area       ? tr("exact area")
                               : each == Antialiasing::None ? tr("1 sample")
                                                            : tr("%1 samples").arg(samples),
                           int(each));
    }
    row->addWidget(m_samples);
    connect(m_samples, &QComboBox::activated, this, [this](int index) {
        Appearance appearance = m_document->scene().appearance;
        appearance.antialiasing = Antialiasing(m_samples->itemData(index).toInt());
        m_document->setAppearance(appearance);
    });
}

} // namespace pixelplumb
