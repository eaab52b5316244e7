// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "widgets/look/viewmapping.h"

#include <QtWidgets>

namespace pixelplumb {

class CompareLink;
class FramePainter;
class Playhead;

/// A picture of the frame, enlarged cell by cell as on the canvas. All views of one link show the
/// same part. A click picks the pixel on the playhead, a drag moves all views, the wheel zooms
/// them.
class CompareView : public QWidget {
    Q_OBJECT

public:
    CompareView(CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);

    /// A picture of the link's frame, line by line; null shows the message instead.
    void setPicture(const QImage &picture);
    /// The text to show without a picture.
    void setMessage(const QString &message);

    ViewMapping mapping() const;
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    QPointF positionOf(const QPoint &pixel) const { return mapping().positionOf(pixel); }

    QSize sizeHint() const override { return {240, 200}; }
    QSize minimumSizeHint() const override { return {72, 60}; }

protected:
    /// Draws over the cells.
    virtual void paintSigns(QPainter &painter, FramePainter &frame, const ViewMapping &mapping);

    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRectF view() const { return rect(); }

    CompareLink *m_link;
    Playhead *m_playhead;
    QImage m_picture;
    QString m_message;
    QImage m_cells; ///< the visible cells in device pixels
    std::optional<QPointF> m_pressed;
    std::optional<QPointF> m_dragged; ///< the drag's last position
    int m_wheelRest = 0; ///< eighths of a degree short of a notch
};

/// The colour of a pixel on which `agreeing` of all contenders agree.
QColor agreementColour(int agreeing, int contenders, const QPalette &palette);

/// The agreement map: each pixel coloured by how many contenders agree on it, with the number in
/// its cell where that has room.
class AgreementView : public CompareView {
    Q_OBJECT

public:
    AgreementView(CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);

    void setContest(const std::shared_ptr<const Contest> &contest); ///< null: none

    QSize sizeHint() const override { return minimumSizeHint(); } // the words below come first

protected:
    void paintSigns(QPainter &painter, FramePainter &frame, const ViewMapping &mapping) override;

private:
    void makePicture();

    std::shared_ptr<const Contest> m_contest;
};

} // namespace pixelplumb
