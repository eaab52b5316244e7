// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <QtWidgets>

namespace pixelplumb {

class ColourButton;

/// The frame of a scene: its size, background, origin and pixel centres.
class FrameDialog : public QDialog {
    Q_OBJECT

public:
    explicit FrameDialog(const FrameSpec &frame, QWidget *parent = nullptr);

    FrameSpec frame() const;

private:
    QSpinBox *addSide(QFormLayout *form, const QString &name, const QString &label, int value);
    void judge();

    FrameSpec m_frame; ///< what the dialog does not show is kept
    QSpinBox *m_width = nullptr;
    QSpinBox *m_height = nullptr;
    ColourButton *m_background = nullptr;
    QComboBox *m_origin = nullptr;
    QComboBox *m_pixelCentre = nullptr;
    QLabel *m_verdict = nullptr;
    QDialogButtonBox *m_buttons = nullptr;
};

} // namespace pixelplumb
