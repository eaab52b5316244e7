// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/framedialog.h"

#include "widgets/look/colourbutton.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/parts.h"

namespace pixelplumb {

FrameDialog::FrameDialog(const FrameSpec &frame, QWidget *parent)
    : QDialog(parent)
    , m_frame(frame)
{
    setObjectName(u"frameDialog"_s);
    setWindowTitle(tr("Frame"));
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    m_width = addSide(form, u"frameWidth"_s, tr("&Width"), frame.width);
    m_height = addSide(form, u"frameHeight"_s, tr("&Height"), frame.height);

    m_background = named(new ColourButton(tr("Background"), this), "frameBackground");
    m_background->setColour(frame.background);
    form->addRow(tr("&Background"), m_background);

    m_origin = named(new QComboBox(this), "frameOrigin");
    m_origin->addItems({tr("lower left, y upward"), tr("upper left, y downward")});
    m_origin->setCurrentIndex(int(frame.origin));
    form->addRow(tr("&Origin"), m_origin);

    m_pixelCentre = named(new QComboBox(this), "framePixelCentre");
    m_pixelCentre->addItems({tr("at (x, y)"), tr("at (x + ½, y + ½)")});
    m_pixelCentre->setCurrentIndex(int(frame.pixelCentre));
    form->addRow(tr("&Pixels are sampled"), m_pixelCentre);

    m_verdict = named(new QLabel(this), "frameVerdict");
    m_verdict->setWordWrap(true);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    withParts(new QVBoxLayout(this), {form, m_verdict, Room(), m_buttons}, 16, 16);
    judge();
}

FrameSpec FrameDialog::frame() const
{
    FrameSpec frame = m_frame;
    frame.width = m_width->value();
    frame.height = m_height->value();
    frame.background = m_background->colour();
    frame.origin = FrameOrigin(m_origin->currentIndex());
    frame.pixelCentre = PixelCentre(m_pixelCentre->currentIndex());
    return frame;
}

QSpinBox *FrameDialog::addSide(QFormLayout *form, const QString &name, const QString &label,
                               int value)
{
    auto *box = new QSpinBox(this);
    box->setObjectName(name);
    box->setRange(1, largestFrameSide);
    box->setValue(value);
    box->setSuffix(tr(" px"));
    box->setAlignment(Qt::AlignRight);
    box->setAccelerated(true);
    connect(box, &QSpinBox::valueChanged, this, &FrameDialog::judge);
    form->addRow(label, box);
    return box;
}

void FrameDialog::judge()
{
    const std::int64_t area = std::int64_t(m_width->value()) * m_height->value();
    const bool fits = area <= largestFrameArea;
    m_verdict->setText(fits ? tr("%1 pixels", nullptr, int(area)).arg(groupedText(area))
                            : tr("%1 pixels are too many: at most %2 fit. Make a side smaller.")
                                  .arg(groupedText(area), groupedText(largestFrameArea)));
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(fits);
}

} // namespace pixelplumb
