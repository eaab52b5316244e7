// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/facestages.h"

#include <QtWidgets>

namespace pixelplumb {

/// A stage's number for display: the shortest decimal of the number used, 20 digits of the exact
/// one, and used − exact in two digits ("0" where they are equal), with a true minus sign.
QString usedText(const StageNumber &number);
QString exactText(const StageNumber &number);
QString errorText(const StageNumber &number);

/// The stages of a face, each with its points and their numbers, used beside exact (objectName
/// "stageTree"). Folded items stay folded from face to face.
class StageTree : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { NameColumn, UsedColumn, ExactColumn, ErrorColumn, ColumnCount };

    explicit StageTree(QWidget *parent = nullptr);

    /// An empty list clears the tree.
    void setStages(const std::vector<ProjectionStage> &stages);

private:
    /// A row with one text over all columns.
    static QTreeWidgetItem *addSentence(QTreeWidgetItem *parent, const QString &text);
    void fillStage(QTreeWidgetItem *item, const ProjectionStage &stage);
    void addNumber(QTreeWidgetItem *parent, const StageNumber &number);
};

} // namespace pixelplumb
