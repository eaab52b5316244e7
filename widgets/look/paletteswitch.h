// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/appearance.h"

#include <QObject>

namespace pixelplumb {

/// The palette that the person chose; applied at once and kept in QSettings.
class PaletteSwitch : public QObject {
    Q_OBJECT

public:
    explicit PaletteSwitch(QObject *parent = nullptr);

    /// What the settings say; PaletteChoice::System at first.
    static PaletteChoice stored();

    PaletteChoice choice() const { return m_choice; }
    /// Applies without storing: the command line's choice is for one run.
    void setForThisRun(PaletteChoice choice);

public slots:
    void choose(pixelplumb::PaletteChoice choice);

signals:
    void changed();

private:
    PaletteChoice m_choice;
};

} // namespace pixelplumb
