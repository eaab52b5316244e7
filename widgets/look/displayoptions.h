// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"

#include <QtCore>

#include <chrono>
#include <optional>

namespace pixelplumb {

/// How the bytes in cells are written: 0 … 255 or 00 … ff.
enum class ByteNotation { Decimal, Hexadecimal };

/// How long Shift alone is held before the canvas shows the truth: longer than it takes to press
/// the second key of a Shift combination.
inline constexpr std::chrono::milliseconds peekDelay(700);

/// What the views draw over the frame; shared by the canvas, the pixel grid and the menus.
class DisplayOptions : public QObject {
    Q_OBJECT
    Q_PROPERTY(bool gridShown READ isGridShown WRITE setGridShown NOTIFY changed)
    Q_PROPERTY(
        bool differencesShown READ areDifferencesShown WRITE setDifferencesShown NOTIFY changed)
    Q_PROPERTY(bool clippingShown READ isClippingShown WRITE setClippingShown NOTIFY changed)
    Q_PROPERTY(bool hexadecimal READ isHexadecimal WRITE setHexadecimal NOTIFY changed)
    Q_PROPERTY(bool truthShown READ isTruthShown WRITE setTruthShown NOTIFY changed)
    Q_PROPERTY(bool studentShown READ isStudentShown WRITE setStudentShown NOTIFY changed)
    Q_PROPERTY(QStringList layers READ layers WRITE setLayers NOTIFY changed)

public:
    using QObject::QObject;

    bool isGridShown() const { return m_grid; }
    bool areDifferencesShown() const { return m_differences; }
    /// Whether the polygon is shown that clipping makes of the current triangle's face.
    bool isClippingShown() const { return m_clipping; }
    bool isHexadecimal() const { return m_hexadecimal; }
    ByteNotation notation() const
    {
        return m_hexadecimal ? ByteNotation::Hexadecimal : ByteNotation::Decimal;
    }
    /// Whether the oracle's finished picture is shown instead of the frame at the position.
    bool isTruthShown() const { return m_truth; }
    /// Whether the student's picture is shown instead of the frame at the position.
    bool isStudentShown() const { return m_student; }
    /// The ids of the layers that lie over the frame.
    const QStringList &layers() const { return m_layers; }
    /// The image to which the affine-map layer takes a triangle; none: that of its first map.
    const std::optional<AffineImage> &affineImage() const { return m_affineImage; }
    void setAffineImage(const std::optional<AffineImage> &image)
    {
        if (m_affineImage == image)
            return;
        m_affineImage = image;
        emit changed();
    }

public slots:
    void setGridShown(bool shown) { change(m_grid, shown); }
    void setDifferencesShown(bool shown) { change(m_differences, shown); }
    void setClippingShown(bool shown) { change(m_clipping, shown); }
    void setHexadecimal(bool hexadecimal) { change(m_hexadecimal, hexadecimal); }
    void setTruthShown(bool shown) { change(m_truth, shown); }
    void setStudentShown(bool shown) { change(m_student, shown); }
    void setLayers(const QStringList &ids)
    {
        if (m_layers == ids)
            return;
        m_layers = ids;
        emit changed();
    }
    /// Adds a layer, or removes it.
    void toggleLayer(const QString &id)
    {
        if (m_layers.removeAll(id) == 0)
            m_layers.append(id);
        emit changed();
    }

signals:
    void changed();

private:
    void change(bool &option, bool value)
    {
        if (option == value)
            return;
        option = value;
        emit changed();
    }

    bool m_grid = true;
    bool m_differences = true;
    bool m_clipping = false;
    bool m_hexadecimal = false;
    bool m_truth = false;
    bool m_student = false;
    QStringList m_layers;
    std::optional<AffineImage> m_affineImage;
};

} // namespace pixelplumb
