// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/motionview.h"

#include "widgets/look/signs.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

MotionView::MotionView(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("motionView"));
    setAccessibleName(tr("The frame in hand"));
}

void MotionView::setPictures(const QImage &now, const QImage &before)
{
    m_now = now;
    m_before = before;
    setAccessibleDescription(tr("%1 pixels came or went").arg(toggledPixels()));
    update();
}

bool MotionView::isToggled(int x, int line) const
{
    const QRgb background = qRgb(0, 0, 0);
    return !m_before.isNull()
        && (m_now.pixel(x, line) == background) != (m_before.pixel(x, line) == background);
}

int MotionView::toggledPixels() const
{
    int count = 0;
    for (int line = 0; line < m_now.height(); ++line) {
        for (int x = 0; x < m_now.width(); ++x)
            count += int(isToggled(x, line));
    }
    return count;
}

void MotionView::paintEvent(QPaintEvent *)
{
    if (m_now.isNull())
        return;
    QPainter painter(this);
    const double fit = std::min(double(width()) / m_now.width(), double(height()) / m_now.height());
    const double cell = fit >= 1 ? std::floor(fit) : fit;
    const QRectF target(0, 0, cell * m_now.width(), cell * m_now.height());
    painter.drawImage(target, m_now);
    if (cell < 3)
        return; // a frame around a cell would hide it
    painter.setPen(QPen(signColour(Sign::Changed, palette()), 1.5));
    for (int line = 0; line < m_now.height(); ++line) {
        for (int x = 0; x < m_now.width(); ++x) {
            if (isToggled(x, line))
                painter.drawRect(QRectF(x * cell + 1, line * cell + 1, cell - 2, cell - 2));
        }
    }
}

} // namespace pixelplumb
