// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/stepicons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>

namespace pixelplumb {

namespace {

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

QIcon stepIcon(StepSign sign) { return QIcon(new StepIconEngine(sign)); }

} // namespace pixelplumb
