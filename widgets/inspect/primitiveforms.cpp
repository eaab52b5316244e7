// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/primitiveforms.h"

#include "core/geometry/shapeediting.h"
#include "core/scene/shapenames.h"

#include <QAction>

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

PrimitiveForms::PrimitiveForms(SceneDocument *document, QWidget *parent)
    : QMenu(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("primitiveForms"));
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
