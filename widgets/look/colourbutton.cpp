// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/colourbutton.h"

#include "core/scene/text/colourtext.h"
#include "widgets/look/parts.h"

#include <QtWidgets>

namespace pixelplumb {

ColourButton::ColourButton(const QString &purpose, QWidget *parent)
    : QToolButton(parent)
    , m_purpose(purpose)
{
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::StrongFocus);
    onEvents(this, {QEvent::PaletteChange}, [this] { updateSwatch(); });
    connect(this, &QToolButton::clicked, this, &ColourButton::ask);
    updateSwatch();
}

void ColourButton::setColour(const Colour &colour)
{
    m_colour = colour;
    updateSwatch();
}

void ColourButton::ask()
{
    if (const std::optional<Colour> colour = askForColour(m_colour, m_purpose, this)) {
        setColour(*colour);
        emit colourChosen(*colour);
    }
}

void ColourButton::updateSwatch()
{
    setIcon(swatch(m_colour, palette()));
    setText(colourText(m_colour));
    setToolTip(tr("%1: %2").arg(m_purpose, colourText(m_colour)));
    setAccessibleName(toolTip());
}

std::optional<Colour> askForColour(const Colour &colour, const QString &title, QWidget *parent)
{
    const QColor chosen = QColorDialog::getColor(QColor::fromRgb(packed(colour)), parent, title);
    if (!chosen.isValid())
        return std::nullopt;
    return unpacked(chosen.rgb());
}

Result<Colour> opaqueColour(const QString &text)
{
    const Result<BlendedColour> read = parseColour(text.trimmed());
    if (read && read->alpha == 255)
        return read->colour;
    return InputError{{},
                      read ? ColourButton::tr("“%1” has an opacity").arg(text) : read.error().found,
                      ColourButton::tr("#rrggbb in hexadecimal digits")};
}

QIcon swatch(const Colour &colour, const QPalette &palette)
{
    constexpr int side = 16;
    constexpr int ratio = 2; // sharp up to scale 2
    QPixmap pixmap(side * ratio, side * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(QColor::fromRgb(packed(colour)));
    QPainter painter(&pixmap);
    painter.setPen(palette.color(QPalette::ButtonText));
    painter.drawRect(QRectF(0.5, 0.5, side - 1, side - 1));
    painter.end();
    return QIcon(pixmap);
}

} // namespace pixelplumb
