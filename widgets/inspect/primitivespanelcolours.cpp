// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/primitivespanel.h"
#include "widgets/inspect/primitivestree.h"
#include "widgets/look/colourbutton.h"
#include "widgets/model/primitivelistmodel.h"

/// Changes the colour of the current row.
namespace pixelplumb {

void PrimitivesPanel::chooseColour()
{
    if (const auto solid = m_model->solidAt(m_tree->currentIndex()))
        return chooseSolidColour(*solid);
    const std::optional<VertexRef> ref = currentRef();
    if (!ref)
        return;
    const bool isWhole = m_model->isPrimitive(m_tree->currentIndex());
    const std::optional<Colour> colour
        = askForColour(m_document->vertexAt(*ref)->colour,
                       isWhole ? tr("Colour of the Primitive") : tr("Colour of the Vertex"), this);
    if (!colour)
        return;
    if (isWhole)
        m_document->setPrimitiveColour(ref->primitive, *colour);
    else
        m_document->setVertexColour(*ref, *colour);
}

void PrimitivesPanel::chooseSolidColour(std::size_t index)
{
    Solid solid = m_document->scene().solids[index];
    const bool isOfCorners
        = solid.kind == SolidKind::Triangle3 || solid.kind == SolidKind::Polygon3;
    const std::optional<Colour> colour = askForColour(
        isOfCorners ? solid.corners.front().colour : solid.colour, tr("Colour of the Solid"), this);
    if (!colour)
        return;
    if (isOfCorners) {
        for (SolidCorner &corner : solid.corners)
            corner.colour = *colour;
    } else {
        solid.colour = *colour;
    }
    m_document->setSolid(index, solid, m_document->newDrag());
}

} // namespace pixelplumb
