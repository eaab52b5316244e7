// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/casegallery.h"
#include "widgets/files/examplefolder.h"
#include "widgets/model/job.h"

#include <QtWidgets>

namespace pixelplumb {

/// The program's own scenes and the families of hard cases, each with a picture and a line on what
/// there is to see. The pictures are drawn one by one in a worker thread, visible ones first; until
/// then text stands in for them.
class ExamplesDialog : public QDialog {
    Q_OBJECT

public:
    ExamplesDialog(const std::vector<Example> &examples, const std::vector<GalleryCase> &cases,
                   QWidget *parent = nullptr);

    int picturesLeft() const; ///< still to be drawn
    bool isDrawn(int row) const { return !m_pictures[std::size_t(row)]; }

signals:
    void sceneChosen(const QString &path);
    void caseChosen(const QString &id); ///< the first case of a family

private:
    using Picture = std::function<QImage()>;

    void addScenes(const std::vector<Example> &examples);
    void addFamilies(const std::vector<GalleryCase> &cases);
    QListWidgetItem *add(const QString &title, const QString &line, const Picture &picture);
    void drawNext();
    int nextRow() const; ///< the next row without its picture; −1 where there is none
    void showPicture(int row, const QImage &picture, const QString &words);
    void choose(const QListWidgetItem *item);

    QListWidget *m_list;
    std::vector<Picture> m_pictures; ///< by row; empty once drawn
    Job m_drawing;
};

} // namespace pixelplumb
