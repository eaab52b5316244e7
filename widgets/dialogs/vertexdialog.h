// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "widgets/model/scenedocument.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace pixelplumb {

class ColourButton;

/// Asks for a vertex's coordinates as a file would write them: 26, 26.5, 53/2.
class VertexDialog : public QDialog {
    Q_OBJECT

public:
    VertexDialog(SceneDocument *document, const VertexRef &ref, QWidget *parent = nullptr);

    void accept() override;

private:
    QLineEdit *addField(const QString &name, const QString &label, Lattice coordinate);
    /// None, and the reason is shown, while a field cannot be read.
    std::optional<LatticePoint> readPosition();
    void check() { readPosition(); }

    SceneDocument *m_document;
    VertexRef m_ref;
    QLineEdit *m_x;
    QLineEdit *m_y;
    QLabel *m_remark;
    QPushButton *m_ok;
};

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
