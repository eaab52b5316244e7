// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/facestages.h"

#include <QTreeWidget>

namespace pixelplumb {

/// A number of a stage for the eye: the shortest decimal of what was used, 20 digits of the exact
/// one, and used − exact in two digits ("0" where they are equal), with a true minus sign.
QString usedText(const StageNumber &number);
QString exactText(const StageNumber &number);
QString errorText(const StageNumber &number);

/// The stages of a face, each with its points and their numbers, used beside exact (objectName
/// "stageTree"). What a person folds stays folded from face to face.
class StageTree : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { NameColumn, UsedColumn, ExactColumn, ErrorColumn, ColumnCount };

    explicit StageTree(QWidget *parent = nullptr);

    /// None empties it.
    void setStages(const std::vector<ProjectionStage> &stages);

private:
    /// A row with one text over all columns.
    static QTreeWidgetItem *addSentence(QTreeWidgetItem *parent, const QString &text);
    void fillStage(QTreeWidgetItem *item, const ProjectionStage &stage);
    void addNumber(QTreeWidgetItem *parent, const StageNumber &number);
};

} // namespace pixelplumb
