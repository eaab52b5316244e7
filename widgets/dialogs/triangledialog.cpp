// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/triangledialog.h"

#include "core/scene/coordinatetext.h"
#include "widgets/look/colourbutton.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace pixelplumb {

TriangleDialog::TriangleDialog(QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("triangleDialog"));
    setWindowTitle(tr("Add a Triangle"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(8);
    grid->addWidget(new QLabel(tr("x"), this), 0, 1);
    grid->addWidget(new QLabel(tr("y"), this), 0, 2);
    grid->addWidget(new QLabel(tr("colour"), this), 0, 3);
    addVertex(grid, 0, {{255, 0, 0}});
    addVertex(grid, 1, {{0, 255, 0}});
    addVertex(grid, 2, {{0, 0, 255}});

    m_verdict = new QLabel(this);
    m_verdict->setObjectName(QStringLiteral("triangleVerdict"));
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(m_verdict->fontMetrics().lineSpacing() * 2);
    m_verdict->setAlignment(Qt::AlignTop);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(16);
    layout->addLayout(grid);
    layout->addWidget(m_verdict);
    layout->addWidget(m_buttons);
    judge();
}

Result<Triangle> TriangleDialog::triangle() const
{
    Triangle triangle;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        const Row &row = m_rows[vertex];
        const Result<SnappedNumber> x = parseCoordinate(row.x->text().trimmed());
        if (!x)
            return InputError{tr("P%1, x").arg(vertex), x.error().found, x.error().expected};
        const Result<SnappedNumber> y = parseCoordinate(row.y->text().trimmed());
        if (!y)
            return InputError{tr("P%1, y").arg(vertex), y.error().found, y.error().expected};
        triangle.vertices[vertex] = {{x->units, y->units}, row.colour->colour()};
    }
    return triangle;
}

void TriangleDialog::addVertex(QGridLayout *grid, int vertex, const Colour &colour)
{
    const QString name = tr("P%1").arg(vertex);
    const auto addField = [&](int gridColumn, const QString &axis) {
        auto *field = new QLineEdit(this);
        field->setObjectName(QStringLiteral("vertex%1%2").arg(vertex).arg(axis));
        field->setAccessibleName(tr("%1 of %2").arg(axis, name));
        field->setPlaceholderText(tr("26, 26.5 or 53/2"));
        field->setAlignment(Qt::AlignRight);
        connect(field, &QLineEdit::textChanged, this, &TriangleDialog::judge);
        grid->addWidget(field, vertex + 1, gridColumn);
        return field;
    };
    Row &row = m_rows[std::size_t(vertex)];
    grid->addWidget(new QLabel(name, this), vertex + 1, 0);
    row.x = addField(1, QStringLiteral("x"));
    row.y = addField(2, QStringLiteral("y"));
    row.colour = new ColourButton(tr("Colour of %1").arg(name), this);
    row.colour->setObjectName(QStringLiteral("vertex%1Colour").arg(vertex));
    row.colour->setColour(colour);
    grid->addWidget(row.colour, vertex + 1, 3);
}

void TriangleDialog::judge()
{
    if (!m_buttons)
        return;
    const Result<Triangle> typed = triangle();
    const bool isEmpty = std::ranges::all_of(
        m_rows, [](const Row &row) { return row.x->text().isEmpty() && row.y->text().isEmpty(); });
    m_verdict->setText(typed || isEmpty ? QString() : typed.error().message());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(typed.isOk());
}

} // namespace pixelplumb
