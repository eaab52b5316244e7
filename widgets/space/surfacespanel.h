// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/surfaces.h"
#include "widgets/model/job.h"
#include "widgets/space/segmentstudy.h"

#include <QWidget>

class QLabel;
class QSlider;
class QTableWidget;
class QTextBrowser;

namespace pixelplumb {

class Playhead;
class SceneDocument;

/// Line, circle, plane and sphere in their three forms at a parameter, and how far a surface's
/// triangles are from it, beside their number and time (objectName "surfacesPanel"; forms
/// "surfaceForms", table "segmentTable"). Surfaces are the scene's first of their kind, or
/// examples, which are labelled as such.
class SurfacesPanel : public QWidget {
    Q_OBJECT

public:
    SurfacesPanel(SceneDocument *document, Playhead *playhead, QWidget *parent = nullptr);

    const std::vector<SegmentFigure> &figures() const { return m_figures; }

signals:
    void figuresChanged();

protected:
    void showEvent(QShowEvent *event) override;

private:
    void takeTraced();
    void fillForms();
    void studySegments();
    void fillSegments();
    QSlider *makeSlider(const QString &name, const QString &tip);

    Playhead *m_playhead;
    QSlider *m_s;
    QSlider *m_t;
    QLabel *m_parameters;
    QTextBrowser *m_forms;
    QLabel *m_segmentSentence;
    QTableWidget *m_segments;
    bool m_isStale = true;
    Solid m_studied; ///< the sphere or patch whose segments are studied
    bool m_isExample = false; ///< m_studied is not the scene's
    std::vector<SegmentFigure> m_figures;
    Job m_job;
};

} // namespace pixelplumb
