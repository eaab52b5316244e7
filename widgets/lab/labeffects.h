// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

#include <QTreeWidget>

namespace pixelplumb {

/// What effects cost and correct, a group per scene (objectName "labEffects").
class LabEffects : public QTreeWidget {
    Q_OBJECT

public:
    explicit LabEffects(QWidget *parent = nullptr);

    void show(const Study &study);
};

} // namespace pixelplumb
