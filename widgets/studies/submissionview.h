// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/studentpicture.h"
#include "widgets/studies/compareview.h"

namespace pixelplumb {

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
