// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"
#include "core/compare/casegallery.h"
#include "core/runs/contender.h"
#include "widgets/model/job.h"
#include "widgets/studies/cases/hardcasespicture.h"

#include <QtWidgets>

#include <map>

namespace pixelplumb {

class HardCasesDetails;
class Playhead;

/// The gallery of hard cases, by family: each with its picture by the current method beside the
/// truth, and whether the method is right. Pictures are drawn one by one in a worker thread while
/// the panel is visible, and cached.
class HardCasesPanel : public QWidget {
    Q_OBJECT

public:
    explicit HardCasesPanel(Playhead *playhead, QWidget *parent = nullptr);

    const std::vector<GalleryCase> &cases() const { return m_cases; }
    /// Reads the cases, which otherwise happens when the panel is first shown.
    void load();
    /// Pictures of the current method still to be drawn.
    int picturesLeft() const;
    /// Chooses a case; false when there is none of that name.
    bool choose(const QString &id);

    QSize sizeHint() const override { return {420, 640}; }

signals:
    /// Shows the case in the stepper at the first pixel that differs.
    void openRequested(const pixelplumb::Scene &scene);
    void compareRequested(const std::vector<pixelplumb::Contender> &contenders);
    void precisionRequested();

private:
    void readCases();
    void fillTree();
    void drawNext();
    void followMethod();
    void showChosen();
    void takePicture(std::size_t index, const HardCasePicture &picture);

    Playhead *m_playhead;
    QTreeWidget *m_tree = nullptr;
    HardCasesDetails *m_details = nullptr;
    std::vector<GalleryCase> m_cases;
    std::vector<QTreeWidgetItem *> m_items; ///< by case
    const Method *m_method = nullptr; ///< the current one
    ScanSettings m_settings;
    /// By method, arithmetic, rule and rounding, then by case.
    std::map<QString, std::map<std::size_t, HardCasePicture>> m_pictures;
    Job m_job;
};

} // namespace pixelplumb
