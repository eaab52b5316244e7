// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/rasterdialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>

namespace pixelplumb {

RasterDialog::RasterDialog(const RasterComparison &comparison, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("rasterDialog"));
    setWindowTitle(tr("The Pasted Raster Beside the Picture"));
    auto *summary = new QLabel(summaryOf(comparison), this);
    summary->setObjectName(QStringLiteral("rasterSummary"));
    auto *legend
        = new QLabel(tr("#  both cover     !  only the picture does     ?  only the pasted "
                        "raster does     .  neither"),
                     this);
    auto *raster = new QPlainTextEdit(comparison.raster, this);
    raster->setObjectName(QStringLiteral("rasterText"));
    raster->setAccessibleName(tr("Raster of differences"));
    raster->setReadOnly(true);
    raster->setLineWrapMode(QPlainTextEdit::NoWrap);
    raster->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(8);
    layout->addWidget(summary);
    layout->addWidget(raster, 1);
    layout->addWidget(legend);
    layout->addWidget(buttons);
    resize(640, 560);
}

QString summaryOf(const RasterComparison &comparison)
{
    const auto count = [](std::int64_t value) {
        return value == 0 ? RasterDialog::tr("none") : QString::number(value);
    };
    return RasterDialog::tr("The pasted raster and the picture: %1 pixels match (#), %2 extra (!), "
                            "%3 missing (?).")
        .arg(count(comparison.matched), count(comparison.extra), count(comparison.missing));
}

} // namespace pixelplumb
