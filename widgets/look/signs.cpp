// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/signs.h"

#include <QtWidgets>

#include <array>

namespace pixelplumb {

namespace {

struct SignLook {
    QRgb onLight;
    QRgb onDark;
    const char *glyph; ///< empty where the sign's position marks it
};

// In the order of Sign. Okabe and Ito 2008: orange e69f00, sky blue 56b4e9, bluish green 009e73,
// yellow f0e442, blue 0072b2, vermillion d55e00, reddish purple cc79a7; darker or lighter by
// palette for contrast.
constexpr std::array<SignLook, 13> signLooks = {{{0x0072b2, 0x56b4e9, ""}, // LowerEdge
                                                 {0xb34700, 0xff9e4a, ""}, // UpperEdge
                                                 {0x00775a, 0x2fd0a0, ""}, // CurrentColumn
                                                 {0x8a3f6e, 0xe39ac4, ""}, // PickedPixel
                                                 {0x0060a0, 0x7cc7f2, "?"}, // Missing
                                                 {0xb34700, 0xffa35c, "!"}, // Extra
                                                 {0x8a3f6e, 0xe39ac4, "c"}, // ColourDiffers
                                                 {0x76690a, 0xf0e442, "="}, // Tie
                                                 {0x9a5a00, 0xf0b53c, "^"}, // Clamp
                                                 {0xb34700, 0xffa35c, "≠"}, // FirstDifference
                                                 {0x404040, 0xd8d8d8, ""}, // VertexMark
                                                 {0xb03020, 0xff7a66, "●"}, // Breakpoint
                                                 {0x00775a, 0x2fd0a0, "•"}}}; // Changed
static_assert(signLooks.size() == std::size_t(Sign::Changed) + 1);

class StepIconEngine final : public QIconEngine {
public:
    explicit StepIconEngine(StepSign sign)
        : m_sign(sign)
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(QGuiApplication::palette().color(group, QPalette::ButtonText));
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / 16.0, rect.height() / 16.0);
        paintSign(painter);
        painter->restore();
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new StepIconEngine(m_sign); }

private:
    /// Paints the sign on a 16 × 16 field.
    void paintSign(QPainter *painter) const
    {
        const QPolygonF rightward({{4, 3}, {4, 13}, {13, 8}});
        const QPolygonF leftward({{12, 3}, {12, 13}, {3, 8}});
        switch (m_sign) {
        case StepSign::ToStart:
            painter->drawRect(QRectF(2, 3, 2, 10));
            painter->drawPolygon(leftward.translated(2, 0));
            return;
        case StepSign::Backward:
            painter->drawPolygon(leftward);
            return;
        case StepSign::Play:
        case StepSign::Forward:
            painter->drawPolygon(rightward);
            return;
        case StepSign::Pause:
            painter->drawRect(QRectF(3.5, 3, 3, 10));
            painter->drawRect(QRectF(9.5, 3, 3, 10));
            return;
        case StepSign::ToEnd:
            painter->drawPolygon(rightward.translated(-2, 0));
            painter->drawRect(QRectF(12, 3, 2, 10));
            return;
        }
    }

    StepSign m_sign;
};

} // namespace

Sign signOf(Difference difference)
{
    switch (difference) {
    case Difference::Missing:
        return Sign::Missing;
    case Difference::Extra:
        return Sign::Extra;
    case Difference::Undecidable:
        return Sign::Tie;
    case Difference::Colour:
    case Difference::None:
        break;
    }
    return Sign::ColourDiffers;
}

QColor signColour(Sign sign, const QPalette &palette)
{
    const SignLook &look = signLooks[std::size_t(sign)];
    return QColor::fromRgb(isDark(palette) ? look.onDark : look.onLight);
}

QString signGlyph(Sign sign) { return QString::fromUtf8(signLooks[std::size_t(sign)].glyph); }

bool isDark(const QPalette &palette) { return palette.color(QPalette::Window).lightness() < 128; }

QIcon stepIcon(StepSign sign) { return QIcon(new StepIconEngine(sign)); }

} // namespace pixelplumb
