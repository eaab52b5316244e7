// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/inspect/pixelgridscene.h"

#include <QWidget>

namespace pixelplumb {

class DisplayOptions;
class Playhead;
enum class BoundsRoom;

/// The pixels around the picked one, large enough to read (objectName "pixelGrid"): their values,
/// sample points, the true edges, and where the current column meets them.
class PixelGrid : public QWidget {
    Q_OBJECT
    Q_PROPERTY(int cellCount READ cellCount WRITE setCellCount NOTIFY cellCountChanged)

public:
    static constexpr int fewestCells = 5;
    static constexpr int mostCells = 33;

    explicit PixelGrid(Playhead *playhead, DisplayOptions *options, QWidget *parent = nullptr);

    /// The number of rows. Until a person chooses it, an upper limit: fewer rows keep the values
    /// readable. Odd, so that there is a middle one.
    int cellCount() const { return m_cellCount; }
    /// Where the cells are now; its frame is just these.
    ViewMapping mapping() const;
    /// The pixel under a position in the widget's coordinates.
    std::optional<QPoint> pixelAt(const QPointF &position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setCellCount(int count); ///< made odd, kept within fewestCells … mostCells

signals:
    void cellCountChanged(int count);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

private:
    QPoint centre() const;
    int largestRowDigits() const;
    BoundsRoom boundsRoom() const;
    void goToWriteOf(const QPoint &pixel);
    QString describe(const QPoint &pixel) const;
    void announce();

    Playhead *m_playhead;
    DisplayOptions *m_options;
    int m_cellCount = 9;
    bool m_isCountChosen = false;
    int m_wheelAngle = 0; ///< turned since the last step, in eighths of a degree
};

} // namespace pixelplumb
