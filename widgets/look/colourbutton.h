// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"
#include "core/scene/text/result.h"

#include <QToolButton>

#include <optional>

namespace pixelplumb {

/// A colour as a swatch with its name; a click asks for another one.
class ColourButton : public QToolButton {
    Q_OBJECT

public:
    explicit ColourButton(const QString &purpose, QWidget *parent = nullptr);

    Colour colour() const { return m_colour; }
    void setColour(const Colour &colour);

signals:
    /// A person chose it; not emitted by setColour().
    void colourChosen(const pixelplumb::Colour &colour);

private:
    void ask();
    void updateSwatch();

    QString m_purpose;
    Colour m_colour;
};

/// Asks a person for a colour; none when the dialog was closed without one.
std::optional<Colour> askForColour(const Colour &colour, const QString &title, QWidget *parent);
/// Reads "#rrggbb": a colour without an opacity of its own.
Result<Colour> opaqueColour(const QString &text);
/// A square of the colour, framed so that it shows on any background.
QIcon swatch(const Colour &colour, const QPalette &palette);

} // namespace pixelplumb
