// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/imageedit.h"

#include "widgets/look/displayoptions.h"

#include <QCoreApplication>

namespace pixelplumb {

ImageEdit::ImageEdit(DisplayOptions &options, const std::optional<AffineImage> &after,
                     const std::optional<int> &drag)
    : QUndoCommand(QCoreApplication::translate("pixelplumb::Canvas", "move image"))
    , m_options(&options)
    , m_before(options.affineImage())
    , m_after(after)
    , m_drag(drag)
{
}

void ImageEdit::redo() { m_options->setAffineImage(m_after); }

void ImageEdit::undo() { m_options->setAffineImage(m_before); }

bool ImageEdit::mergeWith(const QUndoCommand *other)
{
    const auto &edit = static_cast<const ImageEdit &>(*other); // the ids are equal
    if (edit.m_drag != m_drag)
        return false;
    m_after = edit.m_after;
    setObsolete(m_after == m_before); // a drag that came back changed nothing
    return true;
}

} // namespace pixelplumb
