// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/primitivestree.h"

#include "core/geometry/shapeediting.h"
#include "core/scene/shapenames.h"
#include "widgets/model/primitivelistmodel.h"

namespace pixelplumb {

namespace {

Shape ofKind(Shape shape, PrimitiveKind kind)
{
    shape.kind = kind;
    moveVertex(shape, 1, shape.vertices[1].position); // moves a circle's corner onto its square
    return shape;
}

Shape filled(Shape shape, ShapeFill fill)
{
    shape.fill = fill;
    return shape;
}

QString textOf(PrimitiveKind kind, ShapeFill fill)
{
    const bool hasRules = fillNamesOf(kind).size() > 2;
    switch (fill) {
    case ShapeFill::Outline:
        return PrimitiveForms::tr("Outlined");
    case ShapeFill::EvenOdd:
        return PrimitiveForms::tr("Filled by parity (even-odd)");
    case ShapeFill::NonZero:
        break;
    }
    return hasRules ? PrimitiveForms::tr("Filled by winding number (non-zero)")
                    : PrimitiveForms::tr("Filled");
}

} // namespace

PrimitivesTree::PrimitivesTree(QWidget *parent)
    : QTreeView(parent)
{
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                    | QAbstractItemView::AnyKeyPressed);
}

/// False where the current row has no numbers to edit.
bool PrimitivesTree::editCurrent()
{
    if (!currentIndex().flags().testFlag(Qt::ItemIsEditable)) {
        const QModelIndex x = currentIndex().siblingAtColumn(PrimitiveListModel::X);
        if (!x.flags().testFlag(Qt::ItemIsEditable))
            return false;
        setCurrentIndex(x);
    }
    edit(currentIndex());
    return true;
}

void PrimitivesTree::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if ((isEnter || event->key() == Qt::Key_F2) && state() != EditingState && editCurrent())
        return;
    if (isEnter && state() != EditingState && currentIndex().isValid())
        emit colourAsked();
    else
        QTreeView::keyPressEvent(event);
}

void PrimitivesTree::mouseDoubleClickEvent(QMouseEvent *event)
{
    const QModelIndex index = indexAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && index.column() == PrimitiveListModel::ColourText)
        emit colourAsked(); // the first click has made the row current
    else
        QTreeView::mouseDoubleClickEvent(event);
}

QModelIndex PrimitivesTree::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers)
{
    using Model = PrimitiveListModel;
    const QModelIndex index = currentIndex();
    const bool isBetween = (action == MoveNext && index.column() == Model::X)
        || (action == MovePrevious && index.column() == Model::Y);
    if (isBetween)
        return index.siblingAtColumn(action == MoveNext ? Model::Y : Model::X);
    const QModelIndex next = QTreeView::moveCursor(action, modifiers);
    if (action == MoveNext && index.column() == Model::Y)
        return next.siblingAtColumn(Model::X);
    if (action == MovePrevious && index.column() == Model::X)
        return next.siblingAtColumn(Model::Y);
    return next;
}

PrimitiveForms::PrimitiveForms(SceneDocument *document, QWidget *parent)
    : QMenu(parent)
    , m_document(document)
{
    setObjectName(u"primitiveForms"_s);
}

void PrimitiveForms::offer(std::optional<int> primitive)
{
    clear();
    const bool isShape = primitive && m_document->kindOf(*primitive) != PrimitiveKind::Triangle;
    setEnabled(isShape);
    if (!isShape)
        return;
    m_primitive = *primitive;
    const Shape shape = m_document->shapeAt(m_primitive);
    if (shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse) {
        add(tr("Circle"), ofKind(shape, PrimitiveKind::Circle));
        add(tr("Ellipse: its corner is free"), ofKind(shape, PrimitiveKind::Ellipse));
        addSeparator();
    }
    for (const FillName &name : fillNamesOf(shape.kind))
        add(textOf(shape.kind, name.fill), filled(shape, name.fill));
    setEnabled(!isEmpty());
}

void PrimitiveForms::add(const QString &text, const Shape &form)
{
    QAction *action = addAction(text);
    action->setCheckable(true);
    action->setChecked(form == m_document->shapeAt(m_primitive));
    connect(action, &QAction::triggered, this, [this, action, form] {
        action->setChecked(true); // the current form stays checked
        m_document->setForm(m_primitive, form);
    });
}

} // namespace pixelplumb
