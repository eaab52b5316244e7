// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class Playhead;
class SceneDocument;

/// Line, circle, plane and sphere in their three forms at a parameter (objectName "surfacesPanel";
/// forms "surfaceForms"), and sliders for a surface's segments. Surfaces are the scene's first of
/// their kind, or examples, which are labelled as such.
class SurfacesPanel : public QWidget {
    Q_OBJECT

public:
    SurfacesPanel(SceneDocument *document, Playhead *playhead, QWidget *parent = nullptr);

private:
    void takeTraced();
    void fillForms();
    QSlider *makeSlider(const QString &name, const QString &tip);

    Playhead *m_playhead;
    QSlider *m_s;
    QSlider *m_t;
    QLabel *m_parameters;
    QTextBrowser *m_forms;
    bool m_isStale = true;
};

} // namespace pixelplumb
