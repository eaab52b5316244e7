// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "widgets/studies/compareview.h"

namespace pixelplumb {

/// The colour of a pixel on which `agreeing` of all contenders agree.
QColor agreementColour(int agreeing, int contenders, const QPalette &palette);

/// The agreement map: each pixel coloured by how many contenders agree on it, with the number in
/// its cell where that has room. Pixels hidden because they are ahead are left out.
class AgreementView : public CompareView {
    Q_OBJECT

public:
    AgreementView(CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);

    void setContest(const std::shared_ptr<const Contest> &contest); ///< null: none

protected:
    void paintSigns(QPainter &painter, FramePainter &frame, const ViewMapping &mapping) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void makePicture();

    std::shared_ptr<const Contest> m_contest;
};

} // namespace pixelplumb
