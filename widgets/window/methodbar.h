// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

#include <QWidget>

class QBoxLayout;
class QComboBox;

namespace pixelplumb {

class SceneDocument;

/// How the scene is drawn: the method and its arithmetic, fill rule and rounding. The choices are
/// the scene's and go through its undo stack; what a method refuses cannot be chosen and says why.
class MethodBar : public QWidget {
    Q_OBJECT

public:
    explicit MethodBar(SceneDocument *document, QWidget *parent = nullptr);

private:
    QComboBox *makeBox(const QString &name, const QString &label, const QString &toolTip);
    QComboBox *addBox(const QString &name, const QString &label, const QString &toolTip);
    void addMethods();
    void addSettings();
    void followScene();

    SceneDocument *m_document;
    QBoxLayout *m_layout;
    QComboBox *m_method = nullptr;
    QComboBox *m_arithmetic = nullptr;
    QComboBox *m_fillRule = nullptr;
    QComboBox *m_rounding = nullptr;
};

} // namespace pixelplumb
