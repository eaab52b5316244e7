// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/casegallery.h"
#include "widgets/files/examplefolder.h"
#include "widgets/model/job.h"

#include <QDialog>
#include <QImage>

class QListWidget;
class QListWidgetItem;

namespace pixelplumb {

/// The program's own scenes and the families of hard cases, each with a picture and a line on what
/// there is to see. The pictures are drawn one by one beside the GUI thread.
class ExamplesDialog : public QDialog {
    Q_OBJECT

public:
    ExamplesDialog(const std::vector<Example> &examples, const std::vector<GalleryCase> &cases,
                   QWidget *parent = nullptr);

    QWidget *list() const; ///< which holds the pictures
    int picturesLeft() const { return int(m_pictures.size()) - m_nextPicture; }

signals:
    void sceneChosen(const QString &path);
    void caseChosen(const QString &id); ///< the first of a family

private:
    using Picture = std::function<QImage()>;

    void addScenes(const std::vector<Example> &examples);
    void addFamilies(const std::vector<GalleryCase> &cases);
    QListWidgetItem *add(const QString &title, const QString &line, const Picture &picture);
    void drawNext();
    void choose(const QListWidgetItem *item);

    QListWidget *m_list;
    std::vector<Picture> m_pictures; ///< by row
    int m_nextPicture = 0;
    Job m_drawing;
};

} // namespace pixelplumb
