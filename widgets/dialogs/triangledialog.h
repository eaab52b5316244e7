// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/triangle.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/result.h"

#include <QtWidgets>

#include <array>

namespace pixelplumb {

class ColourButton;

/// A triangle as the dialog gives it.
struct TypedTriangle {
    Triangle triangle;
    TriangleAttributes attributes; ///< with an index of no meaning

    friend bool operator==(const TypedTriangle &, const TypedTriangle &) = default;
};

/// A triangle to type in: three rows of x, y, colour and the vertex attributes z, w, u, v and the
/// normal. Numbers as in a scene file: 26, 26.5, 53/2; an empty attribute field is one that a scene
/// file leaves out.
class TriangleDialog : public QDialog {
    Q_OBJECT

public:
    /// For a new triangle.
    explicit TriangleDialog(QWidget *parent = nullptr);
    /// For an existing triangle.
    explicit TriangleDialog(const TypedTriangle &shown, QWidget *parent = nullptr);

    /// The triangle as typed so far, or what is wrong with it.
    Result<TypedTriangle> triangle() const;

private:
    static constexpr std::size_t carriedCount = 7; ///< z, w, u, v, N_x, N_y, N_z

    struct Row {
        QLineEdit *x = nullptr;
        QLineEdit *y = nullptr;
        ColourButton *colour = nullptr;
        std::array<QLineEdit *, carriedCount> carried = {};
    };

    void addVertex(QGridLayout *grid, int vertex, const Colour &colour);
    QLineEdit *addField(QGridLayout *grid, int vertex, int gridColumn, const QString &axis);
    void show(const TypedTriangle &shown);
    Result<VertexAttributes> carriedBy(std::size_t vertex) const;
    SnapReports displacements() const; ///< from the typed numbers to the representable ones
    void judge();

    std::array<Row, 3> m_rows;
    int m_material = noMaterial;
    std::array<std::uint8_t, 3> m_alpha = {255, 255, 255};
    QList<QWidget *> m_carried; ///< titles and fields of what vertices carry, behind m_more
    QCheckBox *m_more = nullptr;
    QLabel *m_verdict = nullptr;
    QDialogButtonBox *m_buttons = nullptr;
};

} // namespace pixelplumb
