// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/colourvision.h"

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace pixelplumb {

/// Shows parts of the window as they look to eyes without one kind of cones; what they show, and
/// every number told, stays. With ordinary vision at first, in each session.
class ColourVisionSwitch : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void addPart(QWidget *part);
    ColourVision choice() const { return m_choice; }

public slots:
    void choose(pixelplumb::ColourVision choice);

signals:
    void changed();

private:
    void showPart(QWidget *part) const;

    std::vector<QPointer<QWidget>> m_parts;
    ColourVision m_choice = ColourVision::Ordinary;
};

} // namespace pixelplumb
