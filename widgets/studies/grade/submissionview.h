// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/compare/compareview.h"

namespace pixelplumb {

/// "Wrong: 12 pixels differ."
QString verdictText(const PictureDiff &diff);
/// How many pixels of each kind, with its glyph in its colour, and whether transparency is ignored;
/// rich text.
QString countsText(const PictureJudgement &judgement, const QPalette &palette);
/// What change of the whole picture explains the differences; empty where none does.
QString causesText(const PictureDiff &diff);
/// The student's pixel beside the expected one.
QString pixelText(const PictureJudgement &judgement, const QPoint &pixel);

/// One of the two pictures of a judgement, with the differing pixels marked.
class SubmissionView : public CompareView {
    Q_OBJECT

public:
    enum class Side { Student, Expected };

    SubmissionView(Side side, CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);

    /// Null shows the message instead.
    void setJudgement(const std::shared_ptr<const PictureJudgement> &judgement);

protected:
    void paintSigns(QPainter &painter, FramePainter &frame, const ViewMapping &mapping) override;

private:
    Side m_side;
    std::shared_ptr<const PictureJudgement> m_judgement;
};

} // namespace pixelplumb
