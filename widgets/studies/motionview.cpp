// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/motionview.h"

#include "widgets/look/signs.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double leastMarkedCell = 3; // logical pixels: in a smaller one a frame would hide it

} // namespace

MotionView::MotionView(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("motionView"));
    setAccessibleName(tr("The frame in hand"));
}

void MotionView::setPicture(const MotionPicture &picture)
{
    m_picture = picture;
    setAccessibleDescription(tr("%n pixels came or went", nullptr, int(picture.toggled.size())));
    update();
}

void MotionView::paintEvent(QPaintEvent *)
{
    const QImage &image = m_picture.image;
    if (image.isNull())
        return;
    QPainter painter(this);
    const double fit = std::min(double(width()) / image.width(), double(height()) / image.height());
    const double cell = fit >= 1 ? std::floor(fit) : fit;
    painter.drawImage(QRectF(0, 0, cell * image.width(), cell * image.height()), image);
    if (cell < leastMarkedCell)
        return;
    painter.setPen(QPen(signColour(Sign::Changed, palette()), 1.5));
    for (const QPoint &pixel : m_picture.toggled)
        painter.drawRect(QRectF(pixel.x() * cell + 1, pixel.y() * cell + 1, cell - 2, cell - 2));
}

} // namespace pixelplumb
