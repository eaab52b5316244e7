// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace pixelplumb {

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

} // namespace pixelplumb
