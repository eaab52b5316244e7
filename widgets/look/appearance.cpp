// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/appearance.h"

#include "core/frame/srgb.h"
#include "widgets/look/signs.h"

#include <array>
#include <utility>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr float tintShare = 0.7F; // window colour in the highlight's tint: texts stay readable
constexpr double cornerRadius = 3;
constexpr float offShare = 0.5F; // window colour in an unchecked button's frame: at least 3:1

QColor frameOf(const QPalette &palette)
{
    return blended(palette.color(QPalette::WindowText), palette.color(QPalette::Window), offShare);
}

bool isToggle(const QWidget *widget)
{
    const auto *button = qobject_cast<const QToolButton *>(widget);
    return button && button->isCheckable();
}

void drawFrame(const QStyleOption &option, QPainter &painter, const QBrush &inside,
               const QColor &frame)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(frame);
    painter.setBrush(inside);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius,
                            cornerRadius);
    painter.restore();
}

constexpr std::array<std::pair<PaletteChoice, const char *>, 3> paletteNames
    = {{{PaletteChoice::System, "system"},
        {PaletteChoice::Light, "light"},
        {PaletteChoice::Dark, "dark"}}};

struct PaletteShade {
    std::vector<QPalette::ColorRole> roles;
    QRgb onLight;
    QRgb onDark;
    QPalette::ColorGroup group = QPalette::All;
};

QPalette paletteOf(QRgb PaletteShade::*side)
{
    using enum QPalette::ColorRole;
    static const std::vector<PaletteShade> shades
        = {{{Window}, 0xf3f3f1, 0x26282b},
           {{Base}, 0xffffff, 0x1b1d1f},
           {{ToolTipBase}, 0xffffff, 0x33363a},
           {{AlternateBase}, 0xf7f7f5, 0x212326},
           {{Button}, 0xececea, 0x33363a},
           {{WindowText, Text, ButtonText, ToolTipText}, 0x1c1e21, 0xe6e7e9},
           {{WindowText, Text, ButtonText}, 0x85888c, 0x84878c, QPalette::Disabled},
           {{PlaceholderText}, 0x6a6d72, 0x9a9da2},
           {{Light}, 0xffffff, 0x4a4e53},
           {{Midlight}, 0xf8f8f6, 0x3d4146},
           {{Mid}, 0xc9cac7, 0x45494e},
           {{Dark}, 0xa4a5a3, 0x151618},
           {{Shadow}, 0x6f706e, 0x0b0c0d},
           {{Highlight}, 0x2f6d9f, 0x2d6290},
           {{Highlight}, 0xc9cac7, 0x45494e, QPalette::Disabled},
           {{HighlightedText, BrightText}, 0xffffff, 0xffffff},
           {{HighlightedText}, 0x1c1e21, 0xe6e7e9, QPalette::Disabled},
           {{Link, LinkVisited}, 0x1f5f94, 0x7fbcec}};
    QPalette palette;
    for (const PaletteShade &shade : shades) {
        for (const QPalette::ColorRole role : shade.roles)
            palette.setColor(shade.group, role, QColor::fromRgb(shade.*side));
    }
    return palette;
}

/// The palette that the desktop gave before we set one.
bool desktopIsDark()
{
    static const bool dark = isDark(QApplication::palette());
    return dark;
}

} // namespace

ToggleStyle::ToggleStyle()
    : QProxyStyle(u"Fusion"_s)
{
}

void ToggleStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                     QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    // In a tool bar an unchecked button has no panel until it is hovered.
    if (control == CC_ToolButton && isToggle(widget) && !option->state.testFlag(State_On))
        drawFrame(*option, *painter, Qt::NoBrush, frameOf(option->palette));
}

void ToggleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option,
                                QPainter *painter, const QWidget *widget) const
{
    if (element == PE_IndicatorCheckBox) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        painter->save();
        painter->setPen(frameOf(option->palette));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
        painter->restore();
        return;
    }
    if (element != PE_PanelButtonTool || !option->state.testFlag(State_On)) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    const QPalette &palette = option->palette;
    drawFrame(
        *option, *painter,
        blended(palette.color(QPalette::Highlight), palette.color(QPalette::Window), tintShare),
        palette.color(QPalette::Link));
}

double luminance(const QColor &colour)
{
    return 0.2126 * linearLight(colour.redF()) + 0.7152 * linearLight(colour.greenF())
        + 0.0722 * linearLight(colour.blueF());
}

QString nameOf(PaletteChoice choice)
{
    for (const auto &[each, name] : paletteNames) {
        if (each == choice)
            return QLatin1String(name);
    }
    return {};
}

std::optional<PaletteChoice> paletteNamed(QStringView name)
{
    for (const auto &[choice, each] : paletteNames) {
        if (name == QLatin1String(each))
            return choice;
    }
    return std::nullopt;
}

QPalette lightPalette() { return paletteOf(&PaletteShade::onLight); }

QPalette darkPalette() { return paletteOf(&PaletteShade::onDark); }

double contrastRatio(const QColor &a, const QColor &b)
{
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

QFont withTabularFigures(const QFont &font)
{
    const auto isTabular = [](const QFont &candidate) {
        const QFontMetricsF metrics(candidate);
        for (char figure = '1'; figure <= '9'; ++figure) {
            if (metrics.horizontalAdvance(QLatin1Char(figure))
                != metrics.horizontalAdvance(QLatin1Char('0')))
                return false;
        }
        return true;
    };
    if (isTabular(font))
        return font;
    for (const char *family : {"DejaVu Sans", "Noto Sans", "Liberation Sans"}) {
        QFont candidate(font);
        candidate.setFamily(QLatin1String(family));
        if (QFontDatabase::hasFamily(QLatin1String(family)) && isTabular(candidate))
            return candidate;
    }
    return font;
}

void applyAppearance(PaletteChoice choice)
{
    const bool darkDesktop = desktopIsDark(); // determined before the palette below hides it
    const bool dark
        = choice == PaletteChoice::Dark || (choice == PaletteChoice::System && darkDesktop);
    if (!qobject_cast<ToggleStyle *>(QApplication::style()))
        QApplication::setStyle(new ToggleStyle);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
    QApplication::setFont(withTabularFigures(QApplication::font()));
}

} // namespace pixelplumb
