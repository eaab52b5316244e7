// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/colourvisionswitch.h"

#include <QGraphicsEffect>
#include <QPainter>
#include <QWidget>

namespace pixelplumb {

namespace {

class ColourVisionEffect final : public QGraphicsEffect {
public:
    ColourVisionEffect(ColourVision vision, QObject *parent)
        : QGraphicsEffect(parent)
        , m_vision(vision)
    {
    }

protected:
    /// In the device's pixels, so that none is scaled.
    void draw(QPainter *painter) override
    {
        QPoint place;
        QImage picture
            = sourcePixmap(Qt::DeviceCoordinates, &place, QGraphicsEffect::NoPad).toImage();
        seeWith(m_vision, picture);
        const QTransform transform = painter->worldTransform();
        painter->setWorldTransform({});
        painter->drawImage(place, picture);
        painter->setWorldTransform(transform);
    }

private:
    ColourVision m_vision;
};

} // namespace

void ColourVisionSwitch::addPart(QWidget *part)
{
    std::erase_if(m_parts, [](const QPointer<QWidget> &gone) { return gone.isNull(); });
    m_parts.emplace_back(part);
    showPart(part);
}

void ColourVisionSwitch::choose(ColourVision choice)
{
    if (choice == m_choice)
        return;
    m_choice = choice;
    for (const QPointer<QWidget> &part : m_parts) {
        if (part)
            showPart(part);
    }
    emit changed();
}

/// Ordinary vision goes without an effect, which would cost a picture beside the window's.
void ColourVisionSwitch::showPart(QWidget *part) const
{
    const bool isOrdinary = m_choice == ColourVision::Ordinary;
    part->setGraphicsEffect(isOrdinary ? nullptr : new ColourVisionEffect(m_choice, part));
    for (QWidget *child : part->findChildren<QWidget *>())
        child->update(); // Qt leaves out those that cover the part's own ground
}

} // namespace pixelplumb
