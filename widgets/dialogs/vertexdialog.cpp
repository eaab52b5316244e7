// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/vertexdialog.h"

#include "core/scene/coordinatetext.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace pixelplumb {

VertexDialog::VertexDialog(SceneDocument *document, const VertexRef &ref, QWidget *parent)
    : QDialog(parent)
    , m_document(document)
    , m_ref(ref)
{
    setObjectName(QStringLiteral("vertexDialog"));
    setWindowTitle(tr("Vertex coordinates"));
    auto *form = new QFormLayout(this);
    const LatticePoint position = document->vertexAt(ref)->position;
    m_x = addField(QStringLiteral("vertexX"), tr("&x, px"), position.x);
    m_y = addField(QStringLiteral("vertexY"), tr("&y, px"), position.y);
    m_remark = new QLabel(this);
    m_remark->setObjectName(QStringLiteral("vertexRemark"));
    m_remark->setWordWrap(true);
    m_remark->setMinimumWidth(m_remark->fontMetrics().averageCharWidth() * 48);
    m_remark->setMinimumHeight(m_remark->fontMetrics().lineSpacing() * 2);
    form->addRow(m_remark);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &VertexDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &VertexDialog::reject);
    m_x->selectAll();
    check();
}

QLineEdit *VertexDialog::addField(const QString &name, const QString &label, Lattice coordinate)
{
    auto *field = new QLineEdit(coordinateText(coordinate), this);
    field->setObjectName(name);
    field->setMaxLength(400);
    connect(field, &QLineEdit::textChanged, this, &VertexDialog::check);
    static_cast<QFormLayout *>(layout())->addRow(label, field);
    return field;
}

std::optional<LatticePoint> VertexDialog::readPosition()
{
    const Result<SnappedNumber> x = parseCoordinate(m_x->text());
    const Result<SnappedNumber> y = parseCoordinate(m_y->text());
    m_ok->setEnabled(x && y);
    if (!x || !y) {
        m_remark->setText(x ? y.error().message() : x.error().message());
        return std::nullopt;
    }
    const bool displaced = x->isDisplaced() || y->isDisplaced();
    m_remark->setText(displaced ? tr("Goes to the nearest 1/256 px: (%1, %2).")
                                      .arg(coordinateText(x->units), coordinateText(y->units))
                                : tr("Whole numbers, decimals and fractions such as 53/2."));
    return LatticePoint{x->units, y->units};
}

void VertexDialog::accept()
{
    const std::optional<LatticePoint> position = readPosition();
    if (!position)
        return;
    m_document->moveVertex(m_ref, *position, m_document->newDrag());
    QDialog::accept();
}

} // namespace pixelplumb
