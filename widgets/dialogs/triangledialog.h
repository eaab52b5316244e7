// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scene/result.h"

#include <QDialog>

#include <array>

class QDialogButtonBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace pixelplumb {

class ColourButton;

/// A triangle typed in: three rows of x, y and colour. Coordinates as in a scene file: 26, 26.5,
/// 53/2.
class TriangleDialog : public QDialog {
    Q_OBJECT

public:
    explicit TriangleDialog(QWidget *parent = nullptr);

    /// The triangle as typed so far, or what is wrong with it.
    Result<Triangle> triangle() const;

private:
    struct Row {
        QLineEdit *x = nullptr;
        QLineEdit *y = nullptr;
        ColourButton *colour = nullptr;
    };

    void addVertex(QGridLayout *grid, int vertex, const Colour &colour);
    void judge();

    std::array<Row, 3> m_rows;
    QLabel *m_verdict = nullptr;
    QDialogButtonBox *m_buttons = nullptr;
};

} // namespace pixelplumb
