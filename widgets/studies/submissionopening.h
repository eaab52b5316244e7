// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/margin.h"
#include "core/scene/scene.h"

#include <QObject>
#include <QPoint>

#include <optional>

namespace pixelplumb {

class Playhead;
class SceneDocument;
class SceneFiles;
class StudentPicture;

/// A graded picture, and the scene that should have been drawn.
struct GradedPicture {
    Scene scene;
    QString results; ///< the folder of the picture
    QString file; ///< in that folder; empty: there is no picture
    QString name; ///< "ada · shallow"
    QString fault; ///< why there is no picture; empty where there is one
    Margin margin = {}; ///< by which it was graded

    bool operator==(const GradedPicture &) const = default;
};

/// Opens a graded picture beside the expected one, at the first pixel that differs.
class SubmissionOpening : public QObject {
    Q_OBJECT

public:
    SubmissionOpening(const SceneDocument *document, SceneFiles *files, StudentPicture *student,
                      Playhead *playhead, QObject *parent);

public slots:
    void open(const pixelplumb::GradedPicture &picture);
    void close(); ///< removes what was opened, if still there

signals:
    void pixelReached(const QPoint &pixel);
    void lost(); ///< it is not shown: the old scene was kept, or another picture replaced it

private:
    void arrive();
    void lose();

    const SceneDocument *m_document;
    SceneFiles *m_files;
    StudentPicture *m_student;
    Playhead *m_playhead;
    std::optional<GradedPicture> m_open;
    QString m_awaited; ///< the picture whose judgement is awaited; empty: none
};

} // namespace pixelplumb
