// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/keyfield.h"

#include <QKeyEvent>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

constexpr std::array modifierKeys
    = {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_AltGr, Qt::Key_Meta, Qt::Key_unknown};

} // namespace

void KeyField::keyPressEvent(QKeyEvent *event)
{
    if (std::ranges::find(modifierKeys, event->key()) != modifierKeys.end())
        return; // Qt would empty the field
    QKeySequenceEdit::keyPressEvent(event);
    setKeySequence(QKeySequence(keySequence()[0])); // which ends the waiting
    emit editingFinished();
}

} // namespace pixelplumb
