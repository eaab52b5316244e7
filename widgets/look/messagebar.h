// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <functional>

namespace pixelplumb {

/// Shows errors and notes over the lower part of a widget without moving it. The bar stays until it
/// is closed, replaced or hidden, or until the person presses a key, or the mouse elsewhere. What
/// lies under it can still be clicked.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Error };

    explicit MessageBar(QWidget *covered);

    QString text() const;
    /// Shows a note beside the picture in the widget, which it must not cover: in the free strip at
    /// its left, or in the upper right corner where that strip is narrow.
    void tellBeside(const std::function<QRect()> &picture, const QString &text);

public slots:
    void tell(const QString &text);
    void complain(const QString &text);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void show(Kind kind, const QString &text);
    void place();
    void placeBelow();
    void placeBeside(const QRect &picture);
    QSize sizeWithin(int limit) const;
    bool isNextChoice(const QObject &watched, const QEvent &event) const;

    bool m_isFresh = false; ///< shown by the event that is being delivered
    std::function<QRect()> m_picture; ///< what a note beside it keeps free; else empty
    QLabel *m_glyph;
    QLabel *m_text;
};

} // namespace pixelplumb
