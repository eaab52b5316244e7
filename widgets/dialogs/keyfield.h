// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequenceEdit>

namespace pixelplumb {

/// Takes one key with its modifiers and shows just that, at once: a field of Qt 6.4 waits for up to
/// three more and shows them. Modifiers alone change nothing.
class KeyField final : public QKeySequenceEdit {
    Q_OBJECT

public:
    using QKeySequenceEdit::QKeySequenceEdit;

protected:
    void keyPressEvent(QKeyEvent *event) override;
};

} // namespace pixelplumb
