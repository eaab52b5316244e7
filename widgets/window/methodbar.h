// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/idlesetting.h"
#include "widgets/window/windowparts.h"

#include <QtWidgets>

namespace pixelplumb {

class MethodBox;
class SceneDocument;

/// How the scene is drawn: the method and its arithmetic, fill rule and rounding. The choices
/// belong to the scene and go through its undo stack; what a method refuses, or what would change
/// nothing, is disabled and says why.
class MethodBar : public QWidget {
    Q_OBJECT

public:
    /// A setting's box, with its tool tip for when there is a choice.
    struct Setting {
        DrawingSetting setting = DrawingSetting::Arithmetic;
        QComboBox *box = nullptr;
        QString meaning;
    };

    explicit MethodBar(SceneDocument *document, QWidget *parent = nullptr);

private:
    Setting addSetting(DrawingSetting setting, const QString &name, const QString &label,
                       const QString &meaning);
    void addSettings();
    void followScene();

    SceneDocument *m_document;
    QBoxLayout *m_layout;
    MethodBox *m_method;
    Setting m_arithmetic;
    Setting m_fillRule;
    Setting m_rounding;
};

/// The methods, by the digits 1 … 9 on the canvas, and departures from the right algorithm. What
/// the method refuses is grey and says why.
class MethodMenu : public QMenu {
    Q_OBJECT

public:
    MethodMenu(const WindowParts &parts, QWidget *window);

private:
    void addMethods(Canvas *canvas);
    void addVariants(); ///< can be combined

    SceneDocument *m_document;
};

} // namespace pixelplumb
