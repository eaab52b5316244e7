// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/triangledialog.h"

#include "core/scene/text/coordinatetext.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/parts.h"
#include "widgets/model/runnotes.h"

namespace pixelplumb {

namespace {

constexpr int firstCarriedColumn = 4; // after the name, x, y and the colour
constexpr std::array carriedNames = {"z", "w", "u", "v", "N_x", "N_y", "N_z"};
constexpr std::size_t divisor = 1; // the index of w
constexpr int besidePlace = 20; ///< room beside the text of a field of x or y, logical px
constexpr int depthWidth = 13; ///< for z: "0.333333333"
constexpr int carriedWidth = 8; ///< for the others

/// The attribute of a vertex at an index of carriedNames.
Attribute &carriedIn(VertexAttributes &vertex, std::size_t index)
{
    if (index < 2)
        return index == divisor ? vertex.w : vertex.z;
    return index < 4 ? vertex.texture[index - 2] : vertex.normal[index - 4];
}

QString axisName(std::size_t index) { return QString::fromLatin1(carriedNames[index]); }

} // namespace

TriangleDialog::TriangleDialog(QWidget *parent)
    : QDialog(parent)
{
    setObjectName(u"triangleDialog"_s);
    setWindowTitle(tr("Add a Triangle"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(8);
    grid->addWidget(new QLabel(tr("x"), this), 0, 1);
    grid->addWidget(new QLabel(tr("y"), this), 0, 2);
    grid->addWidget(new QLabel(tr("colour"), this), 0, 3);
    for (std::size_t i = 0; i < carriedCount; ++i) {
        auto *title = new QLabel(axisName(i), this);
        m_carried += title;
        grid->addWidget(title, 0, firstCarriedColumn + int(i));
    }
    addVertex(grid, 0, {{255, 0, 0}});
    addVertex(grid, 1, {{0, 255, 0}});
    addVertex(grid, 2, {{0, 0, 255}});

    m_verdict = named(new QLabel(this), "triangleVerdict");
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(m_verdict->fontMetrics().lineSpacing() * 2);
    m_verdict->setAlignment(Qt::AlignTop);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    m_more = new QCheckBox(tr("&Depth, texture and normals"), this);
    m_more->setObjectName(u"triangleCarries"_s);
    const auto showCarried = [this](bool shown) {
        for (QWidget *part : std::as_const(m_carried))
            part->setVisible(shown);
    };
    connect(m_more, &QCheckBox::toggled, this, showCarried);
    showCarried(false);

    withParts(new QVBoxLayout(this), {grid, m_more, m_verdict, m_buttons}, 16, 16);
    judge();
}

TriangleDialog::TriangleDialog(const TypedTriangle &shown, QWidget *parent)
    : TriangleDialog(parent)
{
    setWindowTitle(tr("Triangle"));
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Change"));
    show(shown);
}

void TriangleDialog::show(const TypedTriangle &shown)
{
    m_material = shown.attributes.material;
    const VertexAttributes byDefault;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Vertex &vertex = shown.triangle.vertices[i];
        VertexAttributes carried = shown.attributes.vertices[i];
        VertexAttributes standard = byDefault;
        m_alpha[i] = carried.alpha;
        m_rows[i].x->setText(coordinateText(vertex.position.x));
        m_rows[i].y->setText(coordinateText(vertex.position.y));
        m_rows[i].colour->setColour(vertex.colour);
        const bool hasNormal = carried.normal != byDefault.normal;
        for (std::size_t j = 0; j < carriedCount; ++j) {
            const Attribute value = carriedIn(carried, j);
            const bool isShown = j >= 4 ? hasNormal : value != carriedIn(standard, j);
            QLineEdit *field = m_rows[i].carried[j];
            field->setText(isShown ? numberText(value, attributeFormat) : QString());
            if (isShown)
                m_more->setChecked(true);
            field->setCursorPosition(0); // show the first digits of a long number
        }
    }
    judge();
}

Result<VertexAttributes> TriangleDialog::carriedBy(std::size_t vertex) const
{
    VertexAttributes carried;
    carried.alpha = m_alpha[vertex];
    for (std::size_t i = 0; i < carriedCount; ++i) {
        const QString text = m_rows[vertex].carried[i]->text().trimmed();
        if (text.isEmpty())
            continue;
        const Result<SnappedNumber> number = parseNumber(text, attributeFormat);
        const QString place = tr("vertex %1, %2").arg(vertex).arg(axisName(i));
        if (!number)
            return InputError{place, number.error().found, number.error().expected};
        if (i == divisor && number->units <= 0)
            return InputError{place, text, tr("more than 0")};
        carriedIn(carried, i) = number->units;
    }
    return carried;
}

Result<TypedTriangle> TriangleDialog::triangle() const
{
    TypedTriangle typed;
    typed.attributes.material = m_material;
    std::size_t normals = 0;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        const Row &row = m_rows[vertex];
        const Result<SnappedNumber> x = parseCoordinate(row.x->text().trimmed());
        if (!x)
            return InputError{tr("vertex %1, x").arg(vertex), x.error().found, x.error().expected};
        const Result<SnappedNumber> y = parseCoordinate(row.y->text().trimmed());
        if (!y)
            return InputError{tr("vertex %1, y").arg(vertex), y.error().found, y.error().expected};
        const Result<VertexAttributes> carried = carriedBy(vertex);
        if (!carried)
            return carried.error();
        typed.triangle.vertices[vertex] = {{x->units, y->units}, row.colour->colour()};
        typed.attributes.vertices[vertex] = *carried;
        normals += std::size_t(carried->normal != VertexAttributes().normal);
    }
    if (normals != 0 && normals != 3)
        return InputError{tr("N"), tr("a normal of length 0 beside others"),
                          tr("three normals, or none")};
    return typed;
}

SnapReports TriangleDialog::displacements() const
{
    SnapReports reports;
    const auto add = [&reports](std::size_t vertex, const QString &name, const QLineEdit *field,
                                const NumberFormat &format) {
        const QString text = field->text().trimmed();
        const Result<SnappedNumber> number = parseNumber(text, format);
        if (number && number->isDisplaced())
            reports.add({tr("vertex %1, %2").arg(vertex).arg(name), text, *number, &format});
    };
    for (std::size_t vertex = 0; vertex < m_rows.size(); ++vertex) {
        add(vertex, u"x"_s, m_rows[vertex].x, coordinateFormat);
        add(vertex, u"y"_s, m_rows[vertex].y, coordinateFormat);
        for (std::size_t i = 0; i < carriedCount; ++i)
            add(vertex, axisName(i), m_rows[vertex].carried[i], attributeFormat);
    }
    return reports;
}

QLineEdit *TriangleDialog::addField(QGridLayout *grid, int vertex, int gridColumn,
                                    const QString &axis)
{
    auto *field = new QLineEdit(this);
    field->setObjectName(u"vertex%1%2"_s.arg(vertex).arg(axis));
    field->setAccessibleName(tr("%1 of %2").arg(axis, tr("vertex %1").arg(vertex)));
    field->setAlignment(Qt::AlignRight);
    connect(field, &QLineEdit::textChanged, this, &TriangleDialog::judge);
    grid->addWidget(field, vertex + 1, gridColumn);
    return field;
}

void TriangleDialog::addVertex(QGridLayout *grid, int vertex, const Colour &colour)
{
    const QString name = tr("vertex %1").arg(vertex);
    Row &row = m_rows[std::size_t(vertex)];
    grid->addWidget(new QLabel(name, this), vertex + 1, 0);
    row.x = addField(grid, vertex, 1, u"x"_s);
    row.y = addField(grid, vertex, 2, u"y"_s);
    for (QLineEdit *field : {row.x, row.y}) {
        field->setPlaceholderText(tr("26, 26.5 or 53/2"));
        field->setMinimumWidth(field->fontMetrics().horizontalAdvance(field->placeholderText())
                               + besidePlace);
    }
    row.colour = new ColourButton(tr("Colour of %1").arg(name), this);
    row.colour->setObjectName(u"vertex%1Colour"_s.arg(vertex));
    row.colour->setColour(colour);
    grid->addWidget(row.colour, vertex + 1, 3);
    for (std::size_t i = 0; i < carriedCount; ++i) {
        QLineEdit *field = addField(grid, vertex, firstCarriedColumn + int(i), axisName(i));
        field->setPlaceholderText(i == divisor ? u"1"_s : u"0"_s);
        field->setMinimumWidth(field->fontMetrics().averageCharWidth()
                               * (i == 0 ? depthWidth : carriedWidth));
        row.carried[i] = field;
        m_carried += field;
    }
}

void TriangleDialog::judge()
{
    if (!m_buttons)
        return;
    const Result<TypedTriangle> typed = triangle();
    const bool isEmpty = std::ranges::all_of(
        m_rows, [](const Row &row) { return row.x->text().isEmpty() && row.y->text().isEmpty(); });
    m_verdict->setText(typed         ? snapNote(displacements())
                           : isEmpty ? QString()
                                     : typed.error().message());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(typed.isOk());
}

} // namespace pixelplumb
