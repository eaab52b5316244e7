// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <array>
#include <optional>

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

/// Sliders for the segments of the document's first sphere or patch ("segmentsAround" and
/// "segmentsAlong"); hidden where there is none. The moves of one drag are one edit.
class SegmentSliders : public QWidget {
    Q_OBJECT

public:
    explicit SegmentSliders(SceneDocument *document, QWidget *parent = nullptr);

private:
    QSlider *makeSlider(const QString &name, const QString &tip);
    /// The solid's index; none where the document has no sphere and no patch.
    std::optional<std::size_t> solid() const;
    void follow();
    void apply();

    SceneDocument *m_document;
    std::array<QSlider *, 2> m_sliders;
    QLabel *m_numbers;
    int m_drag = 0;
};

} // namespace pixelplumb
